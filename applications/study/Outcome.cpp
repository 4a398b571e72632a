// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/Outcome.hpp"

#include "base/writeFile.hpp"
#include "case/foamFile.hpp"
#include "dictionary/Dictionary.hpp"

#include <algorithm>
#include <fstream>

namespace slosh
{

namespace
{

/// The number behind `words` in a line that holds them.
template <class Number>
void find(const std::string& line, const std::string& words, Number& number)
{
    const auto at = line.find(words);
    if (at != std::string::npos)
    {
        number = static_cast<Number>(std::strtod(line.c_str() + at + words.size(), nullptr));
    }
}

} // namespace

void readSolverLog(const std::filesystem::path& log, Outcome& outcome)
{
    std::ifstream in(log);
    for (std::string line; std::getline(in, line);)
    {
        if (line.rfind("Particles: ", 0) == 0)
        {
            find(line, "Particles: ", outcome.particles);
            find(line, "spacing ", outcome.spacing);
        }
        else if (line.rfind("Steps: ", 0) == 0)
        {
            find(line, "Steps: ", outcome.steps);
            find(line, "evaluations of the rates: ", outcome.evaluations);
        }
    }
}

std::optional<Outcome> readOutcome(const std::filesystem::path& folder, const std::string& file)
{
    if (!std::filesystem::exists(folder / file))
    {
        return std::nullopt;
    }
    const Dictionary dict = Dictionary::read(folder / file, (folder / file).string());
    Outcome outcome;
    outcome.failure = dict.wordOr("failure", "");
    outcome.threads = dict.labelOr("threads", 1, positive);
    outcome.cpuSeconds = dict.scalar("cpuSeconds", unit::second);
    outcome.wallSeconds = dict.scalarOr("wallSeconds", Outcome::unknown, unit::second);
    outcome.peakMemory = dict.scalarOr("peakMemory", Outcome::unknown, unit::none);
    outcome.spacing = dict.scalarOr("spacing", Outcome::unknown, unit::metre);
    outcome.particles = dict.label("particles");
    outcome.steps = dict.label("steps");
    outcome.evaluations = dict.labelOr("evaluations", 0, notNegative);
    dict.refuseUnknown();
    return outcome;
}

void writeOutcome(const std::filesystem::path& folder, const Outcome& outcome, const std::string& file)
{
    Dictionary dict(file);
    if (!outcome.finished())
    {
        std::string failure = outcome.failure;
        std::replace(failure.begin(), failure.end(), '"', '\'');
        std::replace(failure.begin(), failure.end(), '\\', '/');
        dict.set("failure", "\"" + failure + "\"");
    }
    dict.set("threads", outcome.threads);
    dict.set("cpuSeconds", outcome.cpuSeconds);
    if (outcome.wallSeconds >= 0)
    {
        dict.set("wallSeconds", outcome.wallSeconds);
    }
    if (outcome.peakMemory >= 0)
    {
        dict.set("peakMemory", outcome.peakMemory);
    }
    if (outcome.spacing > 0)
    {
        dict.set("spacing", outcome.spacing);
    }
    dict.set("particles", outcome.particles);
    dict.set("steps", outcome.steps);
    dict.set("evaluations", outcome.evaluations);
    writeFile(folder / file, foamHeader("dictionary", ".", file) + dict.text());
}

} // namespace slosh
