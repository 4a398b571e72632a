// SPDX-License-Identifier: GPL-3.0-or-later
#include "FigureUncertainty.hpp"

#include "statistics/Quantity.hpp"
#include "statistics/Summary.hpp"
#include "statistics/studentsT.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slosh
{

namespace
{

constexpr double confidence = 0.95;

void takeFigure(FigureAtSpacing& at)
{
    const Row& first = *at.rows.front();
    double standardError = first.standardError;
    at.figure = first.figure;
    at.count = first.count;
    if (at.rows.size() > 1)
    {
        std::vector<double> members;
        for (const Row* row : at.rows)
        {
            members.push_back(row->figure);
        }
        const Summary summary = summarise(members);
        at.figure = summary.mean;
        at.count = summary.count;
        standardError = summary.standardError;
    }
    if (std::isfinite(standardError) && at.count > 1)
    {
        at.scatter = studentsT(confidence, at.count - 1) * standardError;
    }
}

/// The finished runs that have a figure, by their spacings.
std::vector<FigureAtSpacing> bySpacing(const std::vector<const Row*>& rows, const Comparison& comparison)
{
    std::vector<FigureAtSpacing> figures;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    {
        if (!(*row)->run->outcome.finished() || !std::isfinite((*row)->figure) || !std::isfinite((*row)->spacing))
        {
            continue;
        }
        if (figures.empty() || (*row)->spacing > figures.back().spacing)
        {
            figures.emplace_back();
            figures.back().spacing = (*row)->spacing;
        }
        // From the back, so that the first member stays in front.
        figures.back().rows.insert(figures.back().rows.begin(), *row);
        figures.back().cpuSeconds += (*row)->run->outcome.cpuSeconds;
    }
    if (!comparison.isSeries)
    {
        std::for_each(figures.begin(), figures.end(), takeFigure);
    }
    return figures;
}

/// The series of each spacing at the samples of the finest within the times of all, over sqrt(sum (r - mean r)^2).
Eigen::MatrixXd seriesOf(const std::vector<FigureAtSpacing>& figures, const Comparison& comparison)
{
    const auto read = [&](const FigureAtSpacing& at, std::size_t column)
    {
        return readTimeSeries(
            at.rows.front()->run->folder / "postProcessing/compareSamples" / (comparison.name + ".dat"), column
        );
    };
    std::vector<TimeSeries> all;
    all.reserve(figures.size());
    for (const auto& at : figures)
    {
        all.push_back(read(at, 1));
    }
    const TimeSeries reference = read(figures.front(), 2);
    std::vector<double> times, expected;
    for (std::size_t i = 0; i < all.front().size(); ++i)
    {
        const double t = all.front().t[i];
        if (std::all_of(all.begin(), all.end(), [t](const auto& s) { return s.t.front() <= t && t <= s.t.back(); }))
        {
            times.push_back(t);
            expected.push_back(reference.value[i]);
        }
    }
    const double mean = std::accumulate(expected.begin(), expected.end(), 0.0) / static_cast<double>(expected.size());
    const double size = std::sqrt(std::accumulate(
        expected.begin(), expected.end(), 0.0, [mean](double sum, double r) { return sum + (r - mean) * (r - mean); }
    ));
    Eigen::MatrixXd series(std::ssize(all), std::ssize(times));
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        for (std::size_t k = 0; k < times.size(); ++k)
        {
            series(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = all[i].at(times[k]) / size;
        }
    }
    return series;
}

} // namespace

double FigureUncertainty::size() const
{
    return comparison->isSeries ? 1 : comparison->isShare ? std::abs(finest().figure) : 0;
}

FigureUncertainty
figureUncertainty(const std::vector<const Row*>& rows, const Comparison& comparison, double schemeOrder)
{
    FigureUncertainty result;
    result.comparison = &comparison;
    result.figures = bySpacing(rows, comparison);
    if (result.figures.size() < 2)
    {
        return result;
    }
    Refinement study;
    study.phi =
        comparison.isSeries ? seriesOf(result.figures, comparison) : Eigen::MatrixXd(std::ssize(result.figures), 1);
    std::vector<double> scatter;
    for (std::size_t i = 0; i < result.figures.size(); ++i)
    {
        const FigureAtSpacing& at = result.figures[i];
        study.h.push_back(at.spacing);
        scatter.push_back(std::isfinite(at.scatter) ? at.scatter : 0);
        if (!comparison.isSeries)
        {
            study.phi(static_cast<Eigen::Index>(i), 0) = at.figure;
        }
    }
    result.change = (study.phi.row(1) - study.phi.row(0)).norm();
    if (result.figures.size() >= fewestSpacings && study.phi.allFinite() && study.phi.cols() > 0)
    {
        const bool scatters = std::any_of(scatter.begin(), scatter.end(), [](double s) { return s > 0; });
        result.band = numericalUncertainty(study, scatters ? scatter : std::vector<double>(), schemeOrder);
    }
    return result;
}

} // namespace slosh
