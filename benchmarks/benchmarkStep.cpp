// SPDX-License-Identifier: GPL-3.0-or-later
// A whole step of a half full tank that rolls, by the paper's scheme: step/<2D|3D>/<particles>/onThreads:<n>. Beside
// the time per liquid particle: all over the right-hand sides alone, the shares of the other work in per cent, rebuilt
// lists per 100 steps, memory per particle, walls included.
#include "RollingTank.hpp"
#include "base/threads.hpp"

#include <benchmark/benchmark.h>

#include <map>

namespace
{

using namespace slosh;

void step(benchmark::State& state, int dim, int edge, int threads, int warmUp)
{
    setThreads(threads);
    RollingTank tank(dim, edge, 0.5, ImprovedGaussian{}, Schemes());
    tank.advance(warmUp);
    const WeaklyCompressible& solver = tank.solver();
    const Profile before = solver.profile();
    const long rebuilds = solver.rebuilds();
    for (auto _ : state)
    {
        tank.advance(1);
    }
    const auto n = static_cast<double>(solver.particles().nFluid);
    const auto steps = static_cast<double>(state.iterations());
    const auto spent = [&](Work work) { return solver.profile().seconds(work) - before.seconds(work); };
    double total = 0;
    for (std::size_t k = 0; k < workNames.size(); ++k)
    {
        total += spent(static_cast<Work>(k));
    }
    state.counters["nsPerParticle"] = 1e9 * total / steps / n;
    state.counters["overRightHandSides"] = total / spent(Work::rightHandSides);
    const std::map<std::string, Work> shares = {
        {"walls%", Work::walls},
        {"lists%", Work::lists},
        {"density%", Work::density},
        {"integration%", Work::integration},
        {"timeStep%", Work::timeStep}};
    for (const auto& [name, work] : shares)
    {
        state.counters[name] = 100 * spent(work) / total;
    }
    state.counters["rebuildsPer100"] = 100 * static_cast<double>(solver.rebuilds() - rebuilds) / steps;
    state.counters["bytesPerParticle"] =
        static_cast<double>(solver.bytes()) / static_cast<double>(solver.particles().size());
    state.counters["particles"] = n;
}

struct Size
{
    std::string name;
    int edge2D, edge3D; ///< particles along the tank's edge, half of them above the liquid
    int steps;
};

bool registerAll()
{
    for (const int dim : {2, 3})
    {
        for (const Size& size :
             {Size{"5k", 100, 22, 400}, Size{"50k", 316, 46, 100}, Size{"500k", 1000, 100, 40},
              Size{"4M", 2828, 200, 20}, Size{"10M", 4472, 272, 2}})
        {
            for (const int threads : {1, 2})
            {
                benchmark::RegisterBenchmark(
                    ("step/" + std::to_string(dim) + "D/" + size.name + "/onThreads:" + std::to_string(threads))
                        .c_str(),
                    step, dim, dim == 2 ? size.edge2D : size.edge3D, threads, size.steps / 2
                )
                    ->UseRealTime()
                    ->Iterations(size.steps)
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
    return true;
}

const bool registered [[maybe_unused]] = registerAll();

} // namespace

BENCHMARK_MAIN();
