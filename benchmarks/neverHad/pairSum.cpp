// SPDX-License-Identifier: GPL-3.0-or-later
// The right-hand sides of Eq. 1, ten times, of a disordered block: what Allrun counts the instructions of.
#include "kernels/ImprovedGaussian.hpp"
#include "physics/NoDensityDiffusion.hpp"
#include "physics/NoViscosity.hpp"
#include "physics/pairRates.hpp"

#include <cmath>
#include <cstdio>

using namespace slosh;

int main()
{
    constexpr int edge = 40;
    constexpr double dx = 0.01, h = 1.23 * dx;
    Particles particles;
    particles.resize(edge * edge, 0);
    particles.mass = 1000 * dx * dx;
    particles.spacing = dx;
    for (std::size_t i = 0; i < edge * edge; ++i)
    {
        const auto s = static_cast<double>(i);
        particles.r[i] = dx * Vec(static_cast<double>(i % edge) + 0.1 * std::sin(7 * s),
                                  static_cast<double>(i / edge) + 0.1 * std::sin(11 * s), 0);
        particles.v[i] = Vec(std::sin(13 * s), std::sin(17 * s), 0);
        particles.rho[i] = 1000 + std::sin(19 * s);
        particles.p[i] = 1000 * (1 + std::sin(23 * s));
    }
    using S = Simd<float>;
    constexpr double support = ImprovedGaussian::supportRatio * h;
    NeighbourList list;
    list.build(particles, 1.1 * support, lanesOf<S>);
    PairRecords<float> records(2, {0, 1, 2}, h, support);
    records.enclose(particles, 0.1 * support);
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        records.packPosition(i, particles.r[i]);
        records.packFlow(i, particles.v[i], particles.p[i], particles.rho[i]);
    }
    Rates rates;
    rates.resize(particles.nFluid);
    const BodyForce gravity = BodyForce::gravity(Vec(0, -9.81, 0));
    for (int n = 0; n < 10; ++n)
    {
        pairRates<2, ImprovedGaussian, S, Wanted::both>(records, list, particles, h, gravity, NoViscosity{}, false,
                                                        NoDensityDiffusion{}, rates);
    }
    std::printf("%.10g %.10g\n", rates.acceleration[820].x(), rates.densityRate[820]);
}
