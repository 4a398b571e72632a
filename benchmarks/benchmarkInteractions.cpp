// One right-hand side (continuity, pressure, artificial viscosity): rhs/<2D|3D>/<kernel>[/double|/reference], and how
// it scales with threads: rhs/2D/improvedGaussian/100k/threads:<n>. A block of liquid within four layers of wall, so
// that every liquid particle has all its neighbours; positions off the lattice by up to 0.1 dx; the list has the
// skin of a rolling tank.
#include "kernels/Kernel.hpp"
#include "neighbours/sortByCell.hpp"
#include "solver/makeInteractions.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <omp.h>
#include <random>

namespace
{

using namespace slosh;

struct Block
{
    Particles particles;
    NeighbourList neighbours;
    std::unique_ptr<Interactions> interactions;
    Rates rates;
    double pairs = 0; ///< within the support, per liquid particle
};

/// `edge` liquid particles along each direction.
Particles liquidBlock(int dim, int edge)
{
    constexpr double dx = 0.01;
    constexpr int layers = 4;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(-0.1 * dx, 0.1 * dx);
    std::vector<Vec> liquid, wall;
    const int low = -layers, high = edge + layers;
    for (int k = low; k < high; ++k)
    {
        for (int j = dim == 3 ? low : 0; j < (dim == 3 ? high : 1); ++j)
        {
            for (int i = low; i < high; ++i)
            {
                const auto inside = [&](int n) { return n >= 0 && n < edge; };
                const bool isLiquid = inside(i) && (dim == 2 || inside(j)) && inside(k);
                const Vec x = Vec(i, j, k) * dx;
                if (isLiquid)
                {
                    liquid.push_back(x + Vec(offset(random), dim == 3 ? offset(random) : 0, offset(random)));
                }
                else
                {
                    wall.push_back(x);
                }
            }
        }
    }
    Particles particles;
    particles.resize(static_cast<std::ptrdiff_t>(liquid.size()), static_cast<std::ptrdiff_t>(wall.size()));
    particles.mass = 1000 * std::pow(dx, dim);
    particles.spacing = dx;
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        const bool isLiquid = i < liquid.size();
        particles.r[i] = isLiquid ? liquid[i] : wall[i - liquid.size()];
        particles.v[i] = Vec(std::sin(9 * particles.r[i].z()), 0, std::cos(7 * particles.r[i].x()));
        particles.rho[i] = 1000 + 5 * std::sin(40 * particles.r[i].x());
        particles.p[i] = 400.0 * (particles.rho[i] - 1000);
        particles.id[i] = static_cast<int>(isLiquid ? i : i - liquid.size());
    }
    return particles;
}

Block makeBlock(int dim, const KernelChoice& choice, Precision precision, int edge)
{
    Block block;
    block.particles = liquidBlock(dim, edge);
    // 2D: 20 neighbours within 2h, 43 within 3h; 3D: 79 within 2h (as other codes choose it), 107 within 3h.
    const bool compact = std::visit([](auto k) { return k.supportRatio < 3; }, choice);
    const double hOverDx = dim == 2 ? 1.23 : compact ? 1.33 : 1.0;
    const Kernel kernel(choice, dim, hOverDx * block.particles.spacing);
    const PairGeometry geometry{dim, dim == 2 ? std::array<int, 3>{0, 2, 1} : std::array<int, 3>{0, 1, 2},
                                kernel.smoothingLength()};
    block.interactions =
        makeInteractions(geometry, choice, {ArtificialViscosity{0.03, 20, 1000, 7}, NoDensityDiffusion{}}, precision);
    const double skin = 0.15 * kernel.supportRadius();
    sortByCell(block.particles, kernel.supportRadius() + skin);
    block.neighbours.build(block.particles, kernel.supportRadius() + skin, block.interactions->lanes());
    block.interactions->listBuilt(block.particles, block.neighbours, skin);
    block.interactions->packLiquid(block.particles);
    block.interactions->packWallFlow(block.particles, block.neighbours);
    block.rates.resize(block.particles.nFluid);

    for (std::ptrdiff_t i = 0; i < block.particles.nFluid; ++i)
    {
        const auto row = block.neighbours.row(i);
        for (const int* b = row.begin; b != row.end; ++b)
        {
            block.pairs += *b < block.particles.size() && (block.particles.r[static_cast<std::size_t>(i)] -
                                                           block.particles.r[static_cast<std::size_t>(*b)])
                                                                  .norm() < kernel.supportRadius();
        }
    }
    block.pairs /= static_cast<double>(block.particles.nFluid);
    return block;
}

void rightHandSide(benchmark::State& state, int dim, const KernelChoice& kernel, Precision precision, int edge,
                   int threads)
{
    omp_set_num_threads(threads);
    Block block = makeBlock(dim, kernel, precision, edge);
    const BodyForce force = BodyForce::inTankFrame(Vec(0, 0, -9.81), RigidState());
    for (auto _ : state)
    {
        block.interactions->packLiquid(block.particles);
        block.interactions->rates(Wanted::both, block.neighbours, block.particles, force, block.rates);
        benchmark::DoNotOptimize(block.rates.densityRate.data());
    }
    const auto perSecond = [&](double n) {
        return benchmark::Counter(1e-9 * n,
                                  benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    };
    const auto n = static_cast<double>(block.particles.nFluid);
    state.counters["nsPerParticle"] = perSecond(n);
    state.counters["nsPerPair"] = perSecond(n * block.pairs);
    state.counters["neighbours"] = block.pairs;
    state.counters["particles"] = n;
}

void registerAll()
{
    const std::vector<std::pair<Precision, std::string>> precisions = {
        {Precision::single, ""}, {Precision::doublePrecision, "/double"}, {Precision::reference, "/reference"}};
    for (const int dim : {2, 3})
    {
        for (const KernelChoice& kernel : {KernelChoice(WendlandC2{}), KernelChoice(ImprovedGaussian{}),
                                           KernelChoice(CubicSpline{}), KernelChoice(QuinticSpline{})})
        {
            const std::string name =
                "rhs/" + std::to_string(dim) + "D/" + std::visit([](auto k) { return std::string(k.name); }, kernel);
            for (const auto& [precision, suffix] : precisions)
            {
                benchmark::RegisterBenchmark((name + suffix).c_str(), rightHandSide, dim, kernel, precision,
                                             dim == 2 ? 120 : 26, 1)
                    ->UseRealTime()
                    ->Unit(benchmark::kMicrosecond);
            }
        }
    }
    for (const int threads : {1, 2})
    {
        benchmark::RegisterBenchmark(("rhs/2D/improvedGaussian/100k/onThreads:" + std::to_string(threads)).c_str(),
                                     rightHandSide, 2, ImprovedGaussian{}, Precision::single, 316, threads)
            ->UseRealTime()
            ->Unit(benchmark::kMicrosecond);
        benchmark::RegisterBenchmark(("rhs/3D/improvedGaussian/100k/onThreads:" + std::to_string(threads)).c_str(),
                                     rightHandSide, 3, ImprovedGaussian{}, Precision::single, 46, threads)
            ->UseRealTime()
            ->Unit(benchmark::kMicrosecond);
    }
}

} // namespace

int main(int argc, char** argv)
{
    registerAll();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
    {
        return 1;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
