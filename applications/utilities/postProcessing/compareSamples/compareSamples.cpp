// SPDX-License-Identifier: GPL-3.0-or-later
// Holds what a case has sampled against exact solutions, measurements, other cases and stated figures.
#include "Reference.hpp"
#include "common/Program.hpp"
#include "comparisonRow.hpp"

#include "base/writeFile.hpp"
#include "statistics/comparisonKeys.hpp"
#include "statistics/movingAverage.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace slosh;

namespace
{

namespace fs = std::filesystem;

/// Columns: time, samples, reference (and its band), where the reference is a series; for the pictures.
void writeSeries(const fs::path& file, const TimeSeries& samples, const Reference& reference)
{
    std::ostringstream out;
    out << std::setprecision(8) << "# time  samples  reference" << (reference.band ? "  low  high" : "") << "\n";
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
        const double t = samples.t[i];
        if (t < reference.series->t.front() || t > reference.series->t.back())
        {
            continue;
        }
        out << t << " " << samples.value[i] << " " << reference.series->at(t);
        if (reference.band)
        {
            out << " " << reference.band->first.at(t) << " " << reference.band->second.at(t);
        }
        out << "\n";
    }
    writeFile(file, out.str());
}

namespace comparisonsDict
{

constexpr Key peaks{
    .name = "peaks", .entries = [] { return joined(comparisonKeys(), {referenceKey()}); }, .anyName = true};

} // namespace comparisonsDict

/// All entries of system/comparisonsDict.
Keys comparisonsDictKeys()
{
    return {comparisonsDict::peaks};
}

ComparisonRow compareOne(const Dictionary& dict, const std::string& name, const Case& theCase)
{
    using namespace comparison;
    TimeSeries series =
        readSamples(theCase.root() / "postProcessing" / dict.word(samples), static_cast<int>(dict.label(column)));
    const double factor = dict.scalar(scale), shift = dict.scalar(offset);
    for (double& value : series.value)
    {
        value = factor * value + shift;
    }
    series = movingAverage(series, dict.scalar(filter));
    const double begin = dict.scalarOr(timeStart, series.t.front());
    const double end = dict.scalarOr(timeEnd, series.t.back());
    series = series.between(begin, end);
    if (series.empty())
    {
        throw dict.errorAt(samples, "has no sample between timeStart and timeEnd");
    }
    const std::string title = dict.wordOr(description, name);
    ComparisonRow row;
    try
    {
        Reference reference = readReference(dict.dict(referenceKey()), theCase, series);
        if (reference.series)
        {
            writeSeries(theCase.root() / "postProcessing/compareSamples" / (name + ".dat"), series, reference);
            const bool ownTime = std::isfinite(reference.timeStart) || std::isfinite(reference.timeEnd);
            reference.series = ownTime ? reference.series->between(reference.timeStart, reference.timeEnd)
                                       : reference.series->between(begin, end);
        }
        row = compareWith(reference, series, dict);
    }
    catch (const MissingRecord& missing)
    {
        row.figure = row.error = "-";
        row.reference = "not compared: " + std::string(missing.what());
    }
    row.description = title;
    dict.refuseUnknown(comparisonsDict::peaks.entries());
    return row;
}

/// "" or what lies out of the bound that the comparison sets.
std::string outOfBound(const ComparisonRow& row, const Dictionary& dict)
{
    if (!dict.has(comparison::bound))
    {
        return "";
    }
    std::ostringstream message;
    const double bound = dict.scalar(comparison::bound);
    if (std::abs(row.off) <= bound)
    {
        return "";
    }
    message << "\n    " << row.description << ": ";
    if (std::isnan(row.off))
    {
        message << row.figure << " against " << row.reference;
    }
    else
    {
        message << row.figure << " differs from " << row.reference << " by " << row.off;
    }
    message << "; the bound is " << bound << " (" << dict.placeOf(comparison::bound) << ")";
    return message.str();
}

void compareSamples(const Case& theCase, const std::string& dictName, const std::string& only)
{
    const Dictionary dict = theCase.dictionary(dictName);
    const std::vector<std::string> all = dict.keys();
    if (!only.empty() && std::find(all.begin(), all.end(), only) == all.end())
    {
        throw unknownName("comparison", only, "-only", all);
    }
    std::string table = "# what\tfigure\treference\terror\tsource\n", beyond;
    std::ostringstream numbers;
    numbers << std::setprecision(10) << "# name figure error reference uncertainty referenceUncertainty count\n";
    for (const auto& name : all)
    {
        if (!only.empty() && name != only)
        {
            continue;
        }
        const Dictionary comparison = dict.dict(name);
        ComparisonRow row;
        try
        {
            row = compareOne(comparison, name, theCase);
        }
        catch (const CaseError& error)
        {
            throw CaseError(
                std::string(error.what()) + "\n(" + dict.placeOf(name) + ": comparison " + name + ")", error.kind()
            );
        }
        std::cout << row.description << ": " << row.figure << "; reference " << row.reference << "; error " << row.error
                  << (row.source.empty() ? "" : " (" + row.source + ")") << "\n";
        table +=
            row.description + "\t" + row.figure + "\t" + row.reference + "\t" + row.error + "\t" + row.source + "\n";
        numbers << name << " " << row.value << " " << row.off << " " << row.expected << " " << row.uncertainty << " "
                << row.expectedUncertainty << " " << row.count << "\n";
        beyond += outOfBound(row, comparison);
    }
    const std::string folder = "postProcessing/compareSamples/";
    writeFile(theCase.root() / (folder + "comparisons.dat"), numbers.str());
    writeFile(theCase.root() / (folder + "comparisons.tsv"), table);
    std::cout << "\nWrote " << folder << "comparisons.tsv, comparisons.dat\n";
    if (!beyond.empty())
    {
        throw CaseError("out of bounds:" + beyond);
    }
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "compareSamples", "Compares samples with exact solutions, measurements and stated values.",
        "compareSamples -case tutorials/rollingTank/roll8deg4rad -only left"
    );
    program.addOption("dict", "file", "the comparisons to make; default: system/comparisonsDict");
    program.addOption("only", "name", "make only this comparison");
    program.addFile("system/comparisonsDict", "read: the comparisons to make");
    program.addFile("postProcessing/<function>/", "read: the samples");
    program.addFile("postProcessing/compareSamples/", "written: comparisons.tsv, comparisons.dat, <comparison>.dat");
    program.addDictionary(
        {"system/comparisonsDict",
         "Comparisons made by compareSamples: any number of entries, each with its own name. It prints a line for each "
         "and writes postProcessing/compareSamples/comparisons.tsv (what, figure, reference, error, source), "
         "comparisons.dat (for programs: name, figure, error, the reference's figure, the figure's uncertainty, the "
         "reference's and the number of values whose mean the figure is, as plain numbers, nan or 0 where there is "
         "none), and, if the reference is a series, <name>.dat: time, "
         "samples, reference (and its band).",
         comparisonsDictKeys}
    );
    program.addVariable("SLOSH_MEASURED", "folder of measured records");
    return program.run(
        argc, argv,
        [&]
        {
            compareSamples(
                Case(program.caseFolder()), program.has("dict") ? program.value("dict") : "system/comparisonsDict",
                program.has("only") ? program.value("only") : ""
            );
        }
    );
}
