// SPDX-License-Identifier: GPL-3.0-or-later
// The right-hand sides of Eq. 1, ten times, of a disordered block: what Allrun counts the instructions of.
#include "kernels/ImprovedGaussian.hpp"
#include "physics/NoDensityDiffusion.hpp"
#include "physics/PairSums.hpp"
#include "physics/continuity.hpp"
#include "physics/momentum.hpp"
#include "viscosities/NoViscosity.hpp"

#include <cmath>
#include <cstdio>

using namespace slosh;

namespace
{

using S = SimdOfRows<float>;
constexpr double dx = 0.01, h = 1.23 * dx;

/// What is counted: a function of its own.
[[gnu::noinline]] void rightHandSides(
    const PairSums<2, S>& sums, const ClusterLists& lists, const Particles& particles, std::vector<Vec>& acceleration,
    std::vector<double>& densityRate
)
{
    using First = Momentum<2, NoViscosity::InLoop<S>, S>;
    using Second = Continuity<2, NoDensityDiffusion::AroundParticle<2, S>, S>;
    const double factor = particles.mass * ImprovedGaussian::alpha(2) / (h * h * h);
    sums.ofLiquid(
        lists, false,
        [](const auto&) {
            return gradientSums<ImprovedGaussian>(First{{}, false}, Second{{}});
        },
        [&](std::ptrdiff_t a, const auto& sum)
        {
            acceleration[a] = Vec(-factor * sum[0], -9.81 - factor * sum[1], 0);
            densityRate[a] = factor * sum[2] * particles.rho[a];
        }
    );
}

} // namespace

int main()
{
    constexpr int edge = 40;
    Particles particles;
    particles.resize(edge * edge, 0);
    particles.mass = 1000 * dx * dx;
    particles.spacing = dx;
    for (std::ptrdiff_t i = 0; i < edge * edge; ++i)
    {
        const auto s = static_cast<double>(i);
        particles.r[i] = dx * Vec(static_cast<double>(i % edge) + 0.1 * std::sin(7 * s),
                                  static_cast<double>(i / edge) + 0.1 * std::sin(11 * s), 0);
        particles.v[i] = Vec(std::sin(13 * s), std::sin(17 * s), 0);
        particles.rho[i] = 1000 + std::sin(19 * s);
        particles.p[i] = 1000 * (1 + std::sin(23 * s));
        particles.id[i] = static_cast<int>(i);
    }
    constexpr double support = ImprovedGaussian::supportRatio * h;
    ClusterLists lists;
    lists.build(particles, std::array{0, 1}, 1.1 * support);
    PairSums<2, S> sums({0, 1, 2}, h, support);
    sums.listBuilt(particles, lists, 0.1 * support);
    for (std::ptrdiff_t cluster = 0; cluster < lists.liquid().clusters(); ++cluster)
    {
        sums.records().packLiquid(particles, lists.liquid(), cluster);
    }
    std::vector<Vec> acceleration(particles.nFluid, Vec::Zero());
    std::vector<double> densityRate(particles.nFluid);
    for (int n = 0; n < 10; ++n)
    {
        rightHandSides(sums, lists, particles, acceleration, densityRate);
    }
    std::printf("%.10g %.10g\n", acceleration[820].x(), densityRate[820]);
}
