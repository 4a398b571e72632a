// SPDX-License-Identifier: GPL-3.0-or-later
// One right-hand side (continuity, pressure, artificial viscosity) per liquid particle:
//     rhs/<2D|3D>/<kernel>[/double|/reference]            liquid of a tank that has rolled for 2000 steps
//     rhs/<2D|3D>/<kernel>/lattice                        a lattice, off by up to 0.1 dx
//     rhs/<2D|3D>/<kernel>/<term>                         with another term
//     rhs/<2D|3D>/improvedGaussian/<size>/onThreads:<n>  its scaling, on the lattice
// Walls on all sides, so that every liquid particle has all its neighbours.
#include "RollingTank.hpp"

#include "base/parallel.hpp"
#include "base/threads.hpp"
#include "neighbours/sortByBrick.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <random>

namespace
{

using namespace slosh;

/// Particles along an edge of the tank.
int defaultEdge(int dim)
{
    return dim == 2 ? 120 : 26;
}

/// A full tank's particles after 2000 steps, one flow for all kernels.
const Particles& rolled(int dim)
{
    static std::map<int, Particles> flows;
    if (!flows.contains(dim))
    {
        Schemes schemes;
        schemes.timeIntegration = "positionVerlet";
        RollingTank tank(dim, defaultEdge(dim), 1, WendlandC2{}, schemes);
        tank.advance(2000);
        flows[dim] = tank.solver().particles();
    }
    return flows.at(dim);
}

/// The same tank before it has moved, its liquid off the lattice.
Particles lattice(int dim, int edge)
{
    Particles particles = RollingTank(dim, edge, 1, WendlandC2{}, Schemes()).solver().particles();
    const double dx = particles.spacing;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(-0.1 * dx, 0.1 * dx);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        Vec& r = particles.r[i];
        particles.v[i] = Vec(0, std::cos(7 * r.z()), std::sin(9 * r.y()));
        particles.rho[i] = 1000 + 5 * std::sin(40 * r.y());
        particles.p[i] = 900.0 * (particles.rho[i] - 1000);
        r += Vec(dim == 3 ? offset(random) : 0, offset(random), offset(random));
    }
    return particles;
}

/// Particles within `radius` of a liquid particle, on average.
double neighboursWithin(const Particles& particles, double radius)
{
    CellGrid grid;
    grid.build(particles.r, radius);
    const double pairs = parallelReduce(
        particles.nFluid, 0.0,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            double found = 0;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec& r = particles.r[i];
                grid.forEachNear(r, radius, [&](int j) { found += j != i && (particles.r[j] - r).norm() < radius; });
            }
            return found;
        },
        std::plus<>()
    );
    return pairs / static_cast<double>(particles.nFluid);
}

struct Terms
{
    ViscosityChoice viscosity = ArtificialViscosity{0.03, 30, 1000, 7};
    DensityDiffusionChoice diffusion = NoDensityDiffusion{};
};

void rightHandSide(
    benchmark::State& state, const std::function<Particles()>& start, int dim, const KernelChoice& choice,
    const Terms& terms, Precision precision, int threads
)
{
    setThreads(threads);
    Particles particles = start();
    const Kernel kernel(choice, dim, RollingTank::hOverDx(dim, choice) * particles.spacing);
    const PairGeometry geometry{
        dim, dim == 2 ? std::array<int, 3>{1, 2, 0} : std::array<int, 3>{0, 1, 2}, kernel.smoothingLength()};
    const auto interactions = makeInteractions(geometry, choice, {terms.viscosity, terms.diffusion}, precision);
    const double skin = 0.15 * kernel.supportRadius(); // of a rolling tank
    const BodyForce force = BodyForce::gravity(Vec(0, 0, -9.81));
    ClusterLists lists;
    Rates rates;
    const double support = kernel.supportRadius();
    const std::vector<double> skins(particles.r.size(), skin / 2);
    lists.build(
        particles, sortByBrick(particles, brickEdge(particles, dim, support)),
        std::span(geometry.directions).first(dim), support, skins, true
    );
    interactions->listBuilt(particles, lists, skin);
    std::vector<WallContact> contact;
    const TaitEquation equationOfState{1000, 30, 7};
    rates.resize(particles.nFluid);
    std::chrono::duration<double> ofWalls{};
    for (auto _ : state)
    {
        const auto start = std::chrono::steady_clock::now();
        interactions->see(lists, {force, equationOfState, false}, nullptr, particles, contact); // packs
        ofWalls += std::chrono::steady_clock::now() - start;
        interactions->rates(Wanted::both, lists, particles, force, rates);
        benchmark::DoNotOptimize(rates.densityRate.data());
    }
    const auto perSecond = [&](double n) {
        return benchmark::Counter(
            1e-9 * n, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert
        );
    };
    const auto n = static_cast<double>(particles.nFluid);
    const double pairs = neighboursWithin(particles, kernel.supportRadius());
    state.counters["nsPerParticle"] = perSecond(n);
    state.counters["nsOfWalls"] = 1e9 * ofWalls.count() / (static_cast<double>(state.iterations()) * n);
    state.counters["nsPerPair"] = perSecond(n * pairs);
    state.counters["neighbours"] = pairs;
    state.counters["particles"] = n;
}

bool registerAll()
{
    for (const int dim : {2, 3})
    {
        const auto flow = [dim] { return rolled(dim); };
        const auto onLattice = [dim] { return lattice(dim, defaultEdge(dim)); };
        for (const KernelChoice& kernel :
             {KernelChoice(WendlandC2{}), KernelChoice(ImprovedGaussian{}), KernelChoice(CubicSpline{}),
              KernelChoice(QuinticSpline{})})
        {
            const std::string name =
                "rhs/" + std::to_string(dim) + "D/" + std::visit([](auto k) { return std::string(k.name); }, kernel);
            const auto add = [&](const std::string& suffix, const std::function<Particles()>& start, const Terms& terms,
                                 Precision precision)
            {
                benchmark::RegisterBenchmark(
                    (name + suffix).c_str(), rightHandSide, start, dim, kernel, terms, precision, 1
                )
                    ->Unit(benchmark::kMicrosecond);
            };
            add("", flow, {}, Precision::single);
            add("/double", flow, {}, Precision::doublePrecision);
            add("/reference", flow, {}, Precision::reference);
            add("/lattice", onLattice, {}, Precision::single);
            add("/inviscid", flow, {NoViscosity{}, NoDensityDiffusion{}}, Precision::single);
            add("/laminar", flow, {LaminarViscosity{1e-3}, NoDensityDiffusion{}}, Precision::single);
            Terms diffusive;
            diffusive.diffusion = FourtakasDensityDiffusion{0.1, 30, 1000, 7};
            add("/densityDiffusion", flow, diffusive, Precision::single);
        }
        const std::map<std::string, std::pair<int, int>> sizes = {
            {"5k", {71, 17}}, {"50k", {224, 37}}, {"100k", {316, 46}}};
        for (const auto& [size, edges] : sizes)
        {
            for (const int threads : {1, 2})
            {
                const int edge = dim == 2 ? edges.first : edges.second;
                benchmark::RegisterBenchmark(
                    ("rhs/" + std::to_string(dim) + "D/improvedGaussian/" + size +
                     "/onThreads:" + std::to_string(threads))
                        .c_str(),
                    rightHandSide, [dim, edge] { return lattice(dim, edge); }, dim, ImprovedGaussian{}, Terms(),
                    Precision::single, threads
                )
                    ->UseRealTime()
                    ->Unit(benchmark::kMicrosecond);
            }
        }
    }
    return true;
}

const bool registered [[maybe_unused]] = registerAll();

} // namespace

BENCHMARK_MAIN();
