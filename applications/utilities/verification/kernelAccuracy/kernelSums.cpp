// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernelSums.hpp"

#include "physics/PairSums.hpp"

#include <cmath>

namespace slosh
{

namespace
{

using S = SimdOfRows<float>;

double f(const Vec& x)
{
    return x.squaredNorm();
}

/// The points as liquid of density 1 whose pressure is f, and the probes as walls, which take sums of the liquid around
/// them.
Particles asParticles(const std::vector<Vec>& points, double V, const std::vector<Vec>& probes)
{
    Particles particles;
    particles.resize(static_cast<std::ptrdiff_t>(points.size()), static_cast<std::ptrdiff_t>(probes.size()));
    std::copy(points.begin(), points.end(), particles.r.begin());
    std::copy(probes.begin(), probes.end(), particles.r.begin() + particles.nFluid);
    particles.mass = V;
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        particles.rho[i] = 1;
        particles.p[i] = f(particles.r[i]);
    }
    return particles;
}

/// What a point a gives to the sums of a probe: W, f W and f dW/dx, without their factors.
template <class K>
struct ProbeSums
{
    static constexpr std::size_t W = 0, fW = 1, fdWdx = 2, numbers = 3;
    static constexpr bool ofWalls = true;

    template <class Pair, class SumsA, class SumsProbe>
    void add(const Pair& pair, const SumsA&, const SumsProbe& probe) const
    {
        const S Wab = K::f(pair.q2);
        probe.add(W, Wab);
        probe.addProduct(fW, pair.a.P, Wab);
        probe.subtractProduct(fdWdx, pair.a.P * K::dfByQ(pair.q2), pair.x[0]);
    }
};

/// By the walk of the solver's own loops.
template <int dim, class K>
std::vector<KernelErrors>
errorsOf(const Particles& particles, const Kernel& kernel, double V, const std::vector<Vec>& probes)
{
    using Terms = ProbeSums<K>;
    const double h = kernel.smoothingLength(), reach = kernel.supportRadius();
    ClusterLists lists;
    lists.build(particles, std::array{0, 1, 2}, reach);
    PairSums<dim, S> sums({0, 1, 2}, h, reach);
    sums.listBuilt(particles, lists, reach);
    std::vector<KernelErrors> errors(probes.size());
    const double factor = V * K::alpha(dim) / std::pow(h, dim);
    sums.ofWalls(
        particles, lists, [](std::ptrdiff_t, std::ptrdiff_t) {}, [](const auto&) { return Terms{}; },
        [&](std::ptrdiff_t cluster, const ClusterSums<Terms::numbers>& sums)
        {
            forEachPoint(
                lists.walls(), cluster, sums,
                [&](std::ptrdiff_t k, const std::array<double, Terms::numbers>& at)
                {
                    const Vec& X = probes[k];
                    errors[k] = {
                        factor * at[Terms::fW] - f(X), factor / h * at[Terms::fdWdx] - 2 * X.x(),
                        factor * at[Terms::W] - 1, 0, 0};
                }
            );
        }
    );
    return errors;
}

} // namespace

KernelErrors errorsInDouble(const Kernel& kernel, const std::vector<Vec>& points, double V, const Vec& X)
{
    KernelErrors errors{-f(X), -2 * X.x(), -1, 0, 0};
    for (const Vec& x : points)
    {
        const Vec r = X - x;
        const double distance = r.norm();
        errors.onEdge += std::abs(distance - kernel.supportRadius()) < 1e-6 * kernel.smoothingLength();
        if (distance < kernel.supportRadius())
        {
            const double W = V * kernel.W(distance);
            errors.f += f(x) * W;
            errors.dfdx += f(x) * V * kernel.gradFactor(distance) * r.x();
            errors.unity += W;
            errors.neighbours += 1;
        }
    }
    return errors;
}

std::vector<KernelErrors>
errorsOfPairLoop(const Kernel& kernel, const std::vector<Vec>& points, double V, const std::vector<Vec>& probes)
{
    const Particles particles = asParticles(points, V, probes);
    return std::visit(
        [&](auto choice)
        {
            using K = decltype(choice);
            return kernel.dim() == 2 ? errorsOf<2, K>(particles, kernel, V, probes)
                                     : errorsOf<3, K>(particles, kernel, V, probes);
        },
        kernel.choice()
    );
}

} // namespace slosh
