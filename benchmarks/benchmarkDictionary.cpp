// SPDX-License-Identifier: GPL-3.0-or-later
// Parsing 1 MB of dictionary: nested dictionaries, vectors, dimensioned values, macros and comments.
#include "dictionary/Dictionary.hpp"

#include <benchmark/benchmark.h>

#include <string>

namespace
{

std::string megabyte()
{
    std::string text = "g 9.81; // [m/s^2]\n";
    for (int k = 0; text.size() < 1000000; ++k)
    {
        const std::string n = std::to_string(k);
        text += "probe" + n + "\n{\n    type            searchableBox; /* body */\n    min             (-0.5 " + n +
                " 1e-3);\n    rho             [1 -3 0 0 0 0 0] 998." + n +
                ";\n    inner           { value $g; name \"body number " + n + "\"; }\n}\n";
    }
    return text;
}

void parse(benchmark::State& state)
{
    const std::string text = megabyte();
    for (auto _ : state)
    {
        const slosh::Dictionary dict = slosh::Dictionary::parse(text, "megabyte");
        benchmark::DoNotOptimize(&dict);
    }
    state.SetBytesProcessed(state.iterations() * static_cast<long>(text.size()));
}
BENCHMARK(parse)->Name("dictionary/1MB")->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
