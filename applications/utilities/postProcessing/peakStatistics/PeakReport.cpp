// SPDX-License-Identifier: GPL-3.0-or-later
#include "PeakReport.hpp"

#include "base/numberText.hpp"
#include "statistics/Summary.hpp"
#include "statistics/WeibullFit.hpp"
#include "statistics/movingAverage.hpp"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace slosh
{

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string text(double value)
{
    return numberText(value, 8);
}

TimeSeries samplesOf(const std::filesystem::path& postProcessing, const PeakQuery& query)
{
    const auto refused = [&](const std::string& why) { return errorIn(query.place, query.name + ": " + why); };
    TimeSeries all;
    try
    {
        all = readSamples(postProcessing / query.samples, query.column);
    }
    catch (const CaseError& error)
    {
        throw refused(error.what());
    }
    if (all.between(query.timeStart, query.timeEnd).empty())
    {
        throw refused(
            "no samples from " + text(query.timeStart) + " to " + text(query.timeEnd) + " s; samples range from " +
            text(all.t.front()) + " to " + text(all.t.back()) + " s"
        );
    }
    return movingAverage(all, query.filter);
}

void addSummary(std::vector<Figure>& figures, const std::vector<double>& values)
{
    const Summary summary = summarise(values);
    figures.push_back({"count", static_cast<double>(summary.count), none, none});
    for (const Figure& figure :
         {Figure{"mean", summary.mean, none, none},
          {"standardDeviation", summary.standardDeviation, none, none},
          {"standardError", summary.standardError, none, none},
          {"highestThird", summary.highestThird, none, none},
          {"highestTenth", summary.highestTenth, none, none},
          {"maximum", summary.maximum, none, none}})
    {
        if (!std::isnan(figure.value))
        {
            figures.push_back(figure);
        }
    }
}

/// Mean and deviation of the largest means over a window, those of peaks too near to an end of the record left out.
void addMeans(std::vector<Figure>& figures, std::vector<double> means, double window)
{
    std::erase_if(means, [](double mean) { return std::isnan(mean); });
    const Summary summary = summarise(means);
    const std::string over = "(" + text(window) + "s)";
    for (const auto& [name, value] :
         {std::pair{"mean", summary.mean}, std::pair{"standardDeviation", summary.standardDeviation}})
    {
        if (!std::isnan(value))
        {
            figures.push_back({name + over, value, none, none});
        }
    }
}

void addWeibull(std::vector<Figure>& figures, const std::vector<double>& values, const PeakQuery& query)
{
    const WeibullFit fit(values, query.location);
    const auto add = [&](const std::string& name, const ConfidenceInterval& estimate) {
        figures.push_back({name, estimate.value, estimate.low, estimate.high});
    };
    figures.push_back({"location", query.location, none, none});
    add("scale", fit.scale(query.confidence));
    add("shape", fit.shape(query.confidence));
    add("mostProbableMaximum", fit.valueExceededBy(1 / static_cast<double>(values.size()), query.confidence));
    for (const double probability : query.exceedance)
    {
        add("exceededBy(" + text(probability) + ")", fit.valueExceededBy(probability, query.confidence));
    }
}

/// The first lines of both files.
std::string header(const PeakQuery& query)
{
    std::string lines = "# postProcessing/" + query.samples + ", column " + std::to_string(query.column);
    lines += std::isinf(query.timeStart) ? "" : ", from " + text(query.timeStart) + " s";
    lines += std::isinf(query.timeEnd) ? "" : ", to " + text(query.timeEnd) + " s";
    lines += query.filter > 0 ? ", moving average over " + text(query.filter) + " s" : "";
    return lines + "\n# Peaks above " + text(query.threshold) + ", " + text(query.separation) + " s apart at least\n";
}

} // namespace

PeakReport reportPeaks(const std::filesystem::path& postProcessing, const PeakQuery& query)
{
    PeakReport report{query, {}, {}, {}, ""};
    const TimeSeries samples = samplesOf(postProcessing, query);
    report.peaks = findPeaks(samples, query.threshold, query.separation, query.timeStart, query.timeEnd);
    std::vector<double> values;
    for (const Peak& peak : report.peaks)
    {
        values.push_back(peak.value);
    }
    addSummary(report.figures, values);
    for (const double window : query.windows)
    {
        report.means.push_back(largestMeansAround(report.peaks, samples, window));
        addMeans(report.figures, report.means.back(), window);
    }
    report.remark = WeibullFit::obstacle(values, query.location);
    if (report.remark.empty())
    {
        addWeibull(report.figures, values, query);
    }
    if (values.empty())
    {
        report.remark = "no peak above " + text(query.threshold);
    }
    return report;
}

std::string PeakReport::peaksText() const
{
    std::ostringstream out;
    out << header(query) << "# Value in the unit of the samples, impulse in that unit times s";
    out << (means.empty() ? "" : "; mean: the largest mean over a window of that length that contains the peak")
        << "\n#" << std::setw(15) << "time [s]" << std::setw(16) << "value" << std::setw(16) << "rise time [s]"
        << std::setw(16) << "decay time [s]" << std::setw(16) << "impulse";
    for (const double window : query.windows)
    {
        out << std::setw(16) << "mean " + text(window) + " s";
    }
    out << "\n" << std::setprecision(8);
    for (std::size_t k = 0; k < peaks.size(); ++k)
    {
        const Peak& peak = peaks[k];
        for (const double x : {peak.time, peak.value, peak.riseTime, peak.decayTime, peak.impulse})
        {
            out << std::setw(16) << x;
        }
        for (const auto& ofWindow : means)
        {
            out << std::setw(16) << ofWindow[k];
        }
        out << "\n";
    }
    return out.str();
}

std::string PeakReport::statisticsText() const
{
    std::ostringstream out;
    out << header(query) << "# In the unit of the samples; count and shape are numbers. Weibull distribution above the "
        << "location;\n"
        << (means.empty() ? ""
                          : "# mean(..s), standardDeviation(..s): of the largest means over windows of that length "
                            "around the peaks;\n")
        << "# low and high bound an estimate with confidence " << query.confidence << "\n"
        << std::left << std::setw(28) << "# figure" << std::right << std::setw(16) << "value" << std::setw(16) << "low"
        << std::setw(16) << "high"
        << "\n"
        << std::setprecision(8);
    for (const Figure& figure : figures)
    {
        out << std::left << std::setw(28) << figure.name << std::right << std::setw(16) << figure.value;
        if (!std::isnan(figure.low))
        {
            out << std::setw(16) << figure.low << std::setw(16) << figure.high;
        }
        out << "\n";
    }
    return out.str();
}

} // namespace slosh
