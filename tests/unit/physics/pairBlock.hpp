// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A block of disordered liquid beside a wall, the rates of its pairs, and Eq. 1 as the paper prints it.
#include "../kernels/forEveryKernel.hpp"
#include "kernels/Kernel.hpp"
#include "physics/interactions.hpp"

#include <random>

namespace slosh
{

constexpr double dx = 0.01;
constexpr double rho0 = 1000;
constexpr double c0 = 20;

inline std::array<int, 3> directionsOf(int dim)
{
    return dim == 2 ? std::array<int, 3>{0, 2, 1} : std::array<int, 3>{0, 1, 2};
}

inline std::vector<int> listed(int dim)
{
    return dim == 2 ? std::vector{0, 2} : std::vector{0, 1, 2};
}

/// A disordered block: the lower four layers wall, the rest liquid; in 2D in the xz plane.
inline Particles block(int dim, int edge, double disorder)
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> offset(-disorder * dx, disorder * dx);
    std::vector<Vec> liquid, wall;
    for (int k = -4; k < edge; ++k)
    {
        for (int j = 0; j < (dim == 3 ? edge : 1); ++j)
        {
            for (int i = 0; i < edge; ++i)
            {
                const Vec x = Vec(i, j, k) * dx;
                const Vec moved = x + Vec(offset(random), dim == 3 ? offset(random) : 0, offset(random));
                (k < 0 ? wall : liquid).push_back(k < 0 ? x : moved);
            }
        }
    }
    Particles particles;
    particles.resize(static_cast<std::ptrdiff_t>(liquid.size()), static_cast<std::ptrdiff_t>(wall.size()));
    particles.mass = rho0 * std::pow(dx, dim);
    particles.spacing = dx;
    std::copy(liquid.begin(), liquid.end(), particles.r.begin());
    std::copy(wall.begin(), wall.end(), particles.r.begin() + particles.nFluid);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        const bool isLiquid = i < liquid.size();
        particles.v[i] = isLiquid ? Vec(unit(random), dim == 3 ? unit(random) : 0, unit(random)) : Vec::Zero();
        particles.rho[i] = rho0 * (1 + 0.01 * unit(random));
        particles.p[i] = 3000 + 2000 * unit(random);
        particles.id[i] = static_cast<int>(isLiquid ? i : i - liquid.size());
    }
    return particles;
}

/// The sums over the pairs of particles, walls included as they are.
template <int dim, class K, class S>
struct Sums
{
    ClusterLists lists;
    PairInteractions<dim, K, S> pairs;

    Sums(const Particles& particles, double h, const PairTerms& terms = {}) : pairs({dim, directionsOf(dim), h}, terms)
    {
        const double reach = 1.1 * K::supportRatio * h;
        lists.build(particles, listed(dim), reach);
        pairs.listBuilt(particles, lists, reach);
        for (std::ptrdiff_t c = 0; c < lists.liquid().clusters(); ++c)
        {
            pairs.records().packLiquid(particles, lists.liquid(), c);
        }
        const Clusters& walls = lists.walls();
        for (const int c : lists.wallsInReach())
        {
            std::array<OfCluster<double>, dim> v{};
            OfCluster<double> p{}, rho{};
            rho.fill(1);
            for (int lane = 0; lane < walls.pointsIn(c); ++lane)
            {
                const std::ptrdiff_t w = particles.nFluid + walls.point(walls.firstPlace(c) + lane);
                for (std::size_t d = 0; d < dim; ++d)
                {
                    v[d][lane] = particles.v[w][directionsOf(dim)[d]];
                }
                p[lane] = particles.p[w];
                rho[lane] = particles.rho[w];
            }
            pairs.records().packWalls(c, v, p, rho);
        }
    }
};

inline const BodyForce& noForce()
{
    static const BodyForce force = BodyForce::gravity(Vec::Zero());
    return force;
}

template <int dim, class K, class S>
Rates ratesOf(
    const Particles& particles, const ViscosityChoice& viscosity, const DensityDiffusionChoice& diffusion = {},
    const BodyForce& force = noForce(), bool wallsSlip = false, Wanted wanted = Wanted::both
)
{
    const Sums<dim, K, S> sums(particles, 1.2 * dx, {viscosity, diffusion, wallsSlip});
    Rates rates;
    rates.resize(particles.nFluid);
    sums.pairs.rates(wanted, sums.lists, particles, force, rates);
    return rates;
}

/// The accelerations by viscosity alone.
template <int dim, class K, class S>
std::vector<Vec>
viscousPart(const Particles& particles, double h, const ViscosityChoice& viscosity, bool wallsSlip = false)
{
    const Sums<dim, K, S> sums(particles, h, {viscosity, NoDensityDiffusion{}, wallsSlip});
    std::vector<Vec> viscous(particles.nFluid, Vec::Zero());
    Rates walls;
    walls.resize(particles.nFluid);
    sums.pairs.budgetParts(false, sums.lists, particles, viscous, walls);
    return viscous;
}

/// Eq. 1 as it is printed, over all pairs, with the speed of sound of Tait's equation unchanged.
template <int dim>
Rates asPrinted(const Particles& particles, const Kernel& kernel, double alpha, double gamma)
{
    const double h = kernel.smoothingLength();
    Rates rates;
    rates.resize(particles.nFluid);
    const auto c = [&](double rho) { return c0 * std::pow(rho / rho0, (gamma - 1) / 2); };
    for (std::ptrdiff_t a = 0; a < particles.nFluid; ++a)
    {
        const double rhoA = particles.rho[a];
        for (std::ptrdiff_t b = 0; b < particles.size(); ++b)
        {
            const Vec r = particles.r[a] - particles.r[b];
            const Vec v = particles.v[a] - particles.v[b];
            if (a == b || r.norm() >= kernel.supportRadius())
            {
                continue;
            }
            const double rhoB = particles.rho[b];
            const Vec gradW = kernel.gradFactor(r.norm()) * r;
            rates.densityRate[a] -= rhoA * particles.mass / rhoB * (-v).dot(gradW);
            rates.acceleration[a] -=
                particles.mass * (particles.p[a] / (rhoA * rhoA) + particles.p[b] / (rhoB * rhoB)) * gradW;
            if (v.dot(r) < 0)
            {
                rates.acceleration[a] += particles.mass * alpha * h * (c(rhoA) + c(rhoB)) * v.dot(r) /
                                         ((rhoA + rhoB) * (r.squaredNorm() + 0.01 * h * h)) * gradW;
            }
        }
    }
    return rates;
}

/// Largest difference of two rates over the largest rate.
inline double relativeDifference(const Rates& one, const Rates& other)
{
    double difference = 0, largest = 0, densityDifference = 0, densityLargest = 0;
    for (std::size_t i = 0; i < one.acceleration.size(); ++i)
    {
        difference = std::max(difference, (one.acceleration[i] - other.acceleration[i]).norm());
        largest = std::max(largest, other.acceleration[i].norm());
        densityDifference = std::max(densityDifference, std::abs(one.densityRate[i] - other.densityRate[i]));
        densityLargest = std::max(densityLargest, std::abs(other.densityRate[i]));
    }
    return std::max(difference / largest, densityDifference / densityLargest);
}

} // namespace slosh
