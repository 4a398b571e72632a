// Holds what a case has sampled against exact solutions, measurements, other cases and stated figures.
#include "Reference.hpp"
#include "common/Program.hpp"

#include "base/writeFile.hpp"
#include "statistics/movingAverage.hpp"

#include <charconv>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace slosh;

namespace
{

namespace fs = std::filesystem;

std::string number(double value, int digits = 5)
{
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

std::string withUncertainty(const Estimate& estimate)
{
    if (!std::isfinite(estimate.uncertainty))
    {
        return number(estimate.value);
    }
    const int digits = estimate.uncertainty >= 100 ? 4 : 2; // 732, not 7.3e+02
    return number(estimate.value) + " +- " + number(estimate.uncertainty, digits);
}

std::string percent(double share)
{
    return number(100 * share, 3) + " %";
}

/// One comparison, as it stands in the table.
struct Row
{
    std::string description, figure, reference, error, source;
};

/// (figure - reference)/|reference|.
std::string errorOf(const Estimate& figure, const Estimate& reference)
{
    const double difference = figure.value - reference.value;
    if (reference.value == 0)
    {
        return number(difference, 3);
    }
    return percent(difference / std::abs(reference.value));
}

std::string errorOf(const Estimate& figure, const std::pair<double, double>& range)
{
    const double off = figure.value < range.first    ? figure.value - range.first
                       : figure.value > range.second ? figure.value - range.second
                                                     : 0;
    return off == 0 ? "inside" : number(off, 3) + " outside";
}

/// The share of the reference that the figure is, and what it is held against: the ratio somebody states.
Row ratio(const Dictionary& dict, const Estimate& figure, const Estimate& other, Row row)
{
    const double share = figure.value / other.value;
    row.figure = number(share, 3);
    row.reference = "-";
    row.error = "-";
    if (dict.has("stated"))
    {
        const double stated = dict.scalar("stated", unit::none);
        row.reference = number(stated, 3);
        row.error = number(share - stated, 2);
    }
    return row;
}

Row compare(const Dictionary& dict, const TimeSeries& samples, const Reference& reference)
{
    Row row;
    const std::string unitName = dict.wordOr("unit", "");
    const std::string after = unitName.empty() ? "" : " " + unitName;
    row.source = reference.source;
    const std::string quantity = dict.word("quantity");
    if (quantity == "difference")
    {
        if (!reference.series)
        {
            throw dict.errorAt("reference", "is no series, which 'difference' needs,");
        }
        row.figure = row.error = percent(relativeDifference(samples, *reference.series));
        row.reference = "0";
        return row;
    }
    if (quantity == "shareInside")
    {
        if (!reference.band)
        {
            throw dict.errorAt("reference", "has no lowColumn and highColumn, which 'shareInside' needs,");
        }
        row.figure = percent(shareInside(samples, reference.band->first, reference.band->second));
        row.reference = "95 %";
        row.error = "-";
        return row;
    }
    const Quantity figureOf = readQuantity(dict);
    const Estimate figure = figureOf(samples);
    const bool asRatio = dict.flagOr("ratio", false);
    row.figure = withUncertainty(figure) + after;
    if (reference.range)
    {
        row.reference = number(reference.range->first) + " to " + number(reference.range->second) + after;
        row.error = errorOf(figure, *reference.range);
        return row;
    }
    if (!reference.figure && !reference.series)
    {
        row.reference = row.error = "-";
        return row;
    }
    const Estimate other = reference.figure ? *reference.figure : figureOf(*reference.series);
    if (asRatio)
    {
        return ratio(dict, figure, other, row);
    }
    row.reference = withUncertainty(other) + after;
    // Relative to what an instant is off has no meaning: where time begins is anybody's choice.
    const bool isInstant = quantity == "timeOfMaximum" || quantity == "firstTimeAbove";
    row.error = isInstant ? number(figure.value - other.value, 3) + after : errorOf(figure, other);
    return row;
}

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

Row compareOne(const Dictionary& dict, const std::string& name, const Case& theCase)
{
    TimeSeries samples = readSamples(theCase.root() / "postProcessing" / dict.word("samples"),
                                     static_cast<int>(dict.label("column", notNegative)));
    const double scale = dict.scalarOr("scale", 1, unit::none), offset = dict.scalarOr("offset", 0, unit::none);
    for (double& value : samples.value)
    {
        value = scale * value + offset;
    }
    samples = movingAverage(samples, dict.scalarOr("filter", 0, unit::second, notNegative));
    const double begin = dict.scalarOr("timeStart", samples.t.front(), unit::second);
    const double end = dict.scalarOr("timeEnd", samples.t.back(), unit::second);
    samples = samples.between(begin, end);
    if (samples.empty())
    {
        throw dict.errorAt("samples", "has no sample between timeStart and timeEnd,");
    }
    const std::string description = dict.wordOr("description", name);
    dict.allow({"unit", "quantity", "ratio", "stated", "time", "period", "before", "after", "level"});
    try
    {
        Reference reference = readReference(dict.dict("reference"), theCase, samples);
        if (reference.series)
        {
            writeSeries(theCase.root() / "postProcessing/compareSamples" / (name + ".dat"), samples, reference);
            const bool ownTime = std::isfinite(reference.timeStart) || std::isfinite(reference.timeEnd);
            reference.series = ownTime ? reference.series->between(reference.timeStart, reference.timeEnd)
                                       : reference.series->between(begin, end);
        }
        Row row = compare(dict, samples, reference);
        row.description = description;
        dict.refuseUnknown();
        return row;
    }
    catch (const MissingRecord& missing)
    {
        return {description, "-", "not compared: " + std::string(missing.what()), "-", ""};
    }
}

void compareSamples(const Case& theCase, const std::string& dictName)
{
    const Dictionary dict = theCase.dictionary(dictName);
    std::string table = "# what\tfigure\treference\terror\tsource\n";
    for (const auto& name : dict.keys())
    {
        const Dictionary comparison = dict.dict(name);
        Row row;
        try
        {
            row = compareOne(comparison, name, theCase);
        }
        catch (const CaseError& error)
        {
            throw CaseError(std::string(error.what()) + "\n(the comparison '" + name + "'" + dict.placeOf(name) + ")",
                            error.kind());
        }
        std::cout << row.description << ": " << row.figure << "; reference " << row.reference << "; error " << row.error
                  << (row.source.empty() ? "" : " (" + row.source + ")") << "\n";
        table +=
            row.description + "\t" + row.figure + "\t" + row.reference + "\t" + row.error + "\t" + row.source + "\n";
    }
    const std::string file = "postProcessing/compareSamples/comparisons.tsv";
    writeFile(theCase.root() / file, table);
    std::cout << "\nWrote " << file << "\n";
}

} // namespace

int main(int argc, char** argv)
{
    Program program("compareSamples", "Holds samples against exact solutions, measurements and stated figures.",
                    "compareSamples -case tutorials/damBreak/lobovsky2014");
    program.addOption("dict", "file", "the comparisons to make; default: system/comparisonsDict");
    return program.run(argc, argv,
                       [&]
                       {
                           compareSamples(Case(program.caseFolder()),
                                          program.has("dict") ? program.value("dict") : "system/comparisonsDict");
                       });
}
