// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernelSums.hpp"

#include "physics/walk.hpp"

#include <cmath>

namespace slosh
{

namespace
{

using S = Simd<float>;

double f(const Vec& x)
{
    return x.squaredNorm();
}

/// The points as liquid of density 1 whose pressure is f, and the probes as a wall's particles, whose rows hold all
/// liquid around them.
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

template <int dim, class K>
KernelErrors loopAt(
    const PairRecords<float>& records, const NeighbourRows::Row& row, std::ptrdiff_t probe, const Vec& X, double V,
    double h
)
{
    S sumF(0), sumDfdx(0), sumW(0);
    forPairs<dim, S>(
        records, probe, row,
        [&](const Pair<dim, S>& pair)
        {
            const S W = K::f(pair.q2);
            sumW += W;
            sumF += pair.b.P() * W;
            sumDfdx += pair.b.P() * K::dfByQ(pair.q2) * pair.x[0];
        }
    );
    const double factor = V * K::alpha(dim) / std::pow(h, dim);
    return {
        factor * static_cast<double>(laneSum(sumF)) - f(X),
        factor / h * static_cast<double>(laneSum(sumDfdx)) - 2 * X.x(), factor * static_cast<double>(laneSum(sumW)) - 1,
        0, 0};
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
    const double reach = kernel.supportRadius();
    NeighbourList list;
    list.build(particles, reach, lanesOf<S>);
    PairRecords<float> records(kernel.dim(), {0, 1, 2}, kernel.smoothingLength(), reach);
    records.enclose(particles, reach);
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        records.packPosition(i, particles.r[i]);
        records.packFlow(i, Vec::Zero(), particles.p[i], particles.rho[i]);
    }

    std::vector<KernelErrors> errors;
    const double h = kernel.smoothingLength();
    for (std::size_t k = 0; k < probes.size(); ++k)
    {
        const std::ptrdiff_t probe = particles.nFluid + static_cast<std::ptrdiff_t>(k);
        errors.push_back(std::visit(
            [&](auto choice)
            {
                using K = decltype(choice);
                const auto row = list.row(probe);
                return kernel.dim() == 2 ? loopAt<2, K>(records, row, probe, probes[k], V, h)
                                         : loopAt<3, K>(records, row, probe, probes[k], V, h);
            },
            kernel.choice()
        ));
    }
    return errors;
}

} // namespace slosh
