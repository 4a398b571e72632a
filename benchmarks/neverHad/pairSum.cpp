// SPDX-License-Identifier: GPL-3.0-or-later
// The right-hand sides of Eq. 1, ten times, of a disordered block: what Allrun counts the instructions of.
#include "kernels/ImprovedGaussian.hpp"
#include "physics/NoDensityDiffusion.hpp"
#include "physics/continuity.hpp"
#include "physics/momentum.hpp"
#include "physics/walk.hpp"
#include "viscosities/NoViscosity.hpp"

#include <cmath>
#include <cstdio>

using namespace slosh;

namespace
{

using S = Simd<float>;
constexpr double dx = 0.01, h = 1.23 * dx;

/// What is counted: a function of its own.
[[gnu::noinline]] void rightHandSides(
    const PairRecords<float>& records, const NeighbourList& list, const Particles& particles,
    std::vector<Vec>& acceleration, std::vector<double>& densityRate
)
{
    using First = Momentum<2, NoViscosity::InLoop<S>, S>;
    using Second = Continuity<2, NoDensityDiffusion::AroundParticle<2, S>, S>;
    const double factor = particles.mass * ImprovedGaussian::alpha(2) / (h * h * h);
    walkLiquid<2, S>(
        records, list, particles.nFluid,
        [](std::ptrdiff_t) {
            return gradientSums<ImprovedGaussian>(First{{}, false, {}}, Second{{}});
        },
        [&](std::ptrdiff_t a, const auto& sums)
        {
            const auto& [momentum, continuity] = sums.sums;
            acceleration[a] =
                Vec(-factor * laneSum(momentum.gradient[0]), -9.81 - factor * laneSum(momentum.gradient[1]), 0);
            densityRate[a] = factor * laneSum(continuity.divergence) * particles.rho[a];
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
    }
    constexpr double support = ImprovedGaussian::supportRatio * h;
    NeighbourList list;
    list.build(particles, 1.1 * support, lanesOf<S>);
    PairRecords<float> records(2, {0, 1, 2}, h, support);
    records.enclose(particles, 0.1 * support);
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
    {
        records.packPosition(i, particles.r[i]);
        records.packFlow(i, particles.v[i], particles.p[i], particles.rho[i]);
    }
    std::vector<Vec> acceleration(particles.nFluid, Vec::Zero());
    std::vector<double> densityRate(particles.nFluid);
    for (int n = 0; n < 10; ++n)
    {
        rightHandSides(records, list, particles, acceleration, densityRate);
    }
    std::printf("%.10g %.10g\n", acceleration[820].x(), densityRate[820]);
}
