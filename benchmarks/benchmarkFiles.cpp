// SPDX-License-Identifier: GPL-3.0-or-later
// A time directory of a million liquid particles: files/<write|read>/<binary|ascii>/1M.
#include "particles/particleFiles.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{

using namespace slosh;
namespace fs = std::filesystem;

Particles million()
{
    constexpr int edge = 100;
    Particles particles;
    particles.resize(edge * edge * edge, 0);
    particles.mass = 1e-3;
    particles.spacing = 0.01;
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        const auto k = static_cast<double>(i);
        particles.r[i] = Vec(std::sin(k), std::cos(k), 1e-6 * k);
        particles.v[i] = Vec(std::cos(3 * k), std::sin(3 * k), 1e-7 * k);
        particles.rho[i] = 1000 + std::sin(0.01 * k);
        particles.p[i] = 1e4 * std::cos(0.02 * k);
        particles.id[i] = static_cast<int>(i);
    }
    return particles;
}

void files(benchmark::State& state, WriteFormat format, bool reading)
{
    const fs::path folder = fs::temp_directory_path() / ("benchmarkFiles." + std::to_string(::getpid()));
    fs::create_directories(folder / "constant");
    fs::create_directories(folder / "system");
    std::ofstream(folder / "system/controlDict") << "endTime 1;\n";
    const Case theCase(folder);
    const Particles particles = million();
    WriteOptions options;
    options.format = format;
    const auto write = [&] { writeTime(theCase, "0", particles, TimeState(), options); };
    write();
    for (auto _ : state)
    {
        TimeState start;
        reading ? benchmark::DoNotOptimize(readTime(theCase, "0", start).r.data()) : write();
    }
    fs::remove_all(folder);
}

} // namespace

BENCHMARK_CAPTURE(files, write, WriteFormat::binary, false)
    ->Name("files/write/binary/1M")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(files, write, WriteFormat::ascii, false)
    ->Name("files/write/ascii/1M")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(files, read, WriteFormat::binary, true)
    ->Name("files/read/binary/1M")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(files, read, WriteFormat::ascii, true)
    ->Name("files/read/ascii/1M")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

BENCHMARK_MAIN();
