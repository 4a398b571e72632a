// SPDX-License-Identifier: GPL-3.0-or-later
// Histories and spectra: a figure for each quantity that a function object has sampled.
#include "Figure.hpp"
#include "sections.hpp"

#include "statistics/Spectrum.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

/// Curves of one quantity of a file.
struct Panel
{
    std::string quantity, unit;
    std::vector<Figure::Curve> curves;
    std::size_t leftOut = 0;
};

constexpr std::size_t mostCurves = 8;

bool varies(const TimeSeries& series)
{
    return std::adjacent_find(series.value.begin(), series.value.end(), std::not_equal_to<>()) != series.value.end();
}

std::vector<Panel> panelsOf(const SampledFile& file, double from)
{
    std::vector<Panel> panels;
    std::vector<std::pair<SampledFile::Column, TimeSeries>> columns;
    bool oneVaries = false;
    for (const auto& column : file.columns)
    {
        if (column.usual)
        {
            const TimeSeries all = file.series(column);
            columns.emplace_back(column, all.between(from, INFINITY));
            oneVaries = oneVaries || varies(columns.back().second);
        }
    }
    for (auto& [column, series] : columns)
    {
        // The empty direction of a 2D tank, a probe that stays dry.
        if (series.empty() || (oneVaries && column.place.empty() && !varies(series)))
        {
            continue;
        }
        const auto& wanted = column;
        auto panel = std::find_if(
            panels.begin(), panels.end(),
            [&](const Panel& one) { return one.quantity == wanted.quantity && one.unit == wanted.unit; }
        );
        if (panel == panels.end())
        {
            panel = panels.insert(panel, Panel{column.quantity, column.unit, {}, 0});
        }
        if (panel->curves.size() == mostCurves)
        {
            ++panel->leftOut;
            continue;
        }
        std::string legend = column.name + (column.place.empty() ? "" : " " + column.place);
        if (file.file == "energies.dat" && column.name == "potential")
        {
            // Of an energy of position only changes mean something.
            const double start = series.value.front();
            for (double& value : series.value)
            {
                value -= start;
            }
            legend += (start < 0 ? " + " : " - ") + number(std::abs(start)) + " J";
        }
        panel->curves.push_back({legend, series});
    }
    return panels;
}

/// Large pressures, forces and energies in thousands of their unit.
void shorten(Panel& panel)
{
    double largest = 0;
    for (const auto& curve : panel.curves)
    {
        for (const double value : curve.points.value)
        {
            largest = std::max(largest, std::abs(value));
        }
    }
    if (largest < 2000 || (panel.unit != "Pa" && panel.unit != "N" && panel.unit != "N m" && panel.unit != "J"))
    {
        return;
    }
    panel.unit = "k" + panel.unit;
    for (auto& curve : panel.curves)
    {
        for (double& value : curve.points.value)
        {
            value /= 1000;
        }
    }
}

std::string captionOf(const SampledFile& file, const Panel& panel)
{
    const std::string name = file.name();
    return (name == panel.quantity ? name : name + ": " + panel.quantity) +
           (panel.leftOut == 0 ? ""
                               : "; the first " + std::to_string(mostCurves) + " of " +
                                     std::to_string(mostCurves + panel.leftOut) + " curves") +
           (file.changed ? "; samples with other columns before a restart are omitted" : "");
}

/// "particles outside stays at 0", where no curve of the panel moves; else nothing.
std::string stillness(const Panel& panel)
{
    std::string text;
    for (const auto& curve : panel.curves)
    {
        if (varies(curve.points))
        {
            return "";
        }
        text += (text.empty() ? "" : ", ") + curve.legend + " stays at " + number(curve.points.value.front()) +
                (panel.unit.empty() ? "" : " " + panel.unit);
    }
    return text;
}

std::string withUnit(const std::string& quantity, const std::string& unitName)
{
    return quantity + (unitName.empty() ? "" : " [" + unitName + "]");
}

/// Marks for the natural frequencies and the motion's.
std::vector<Figure::Mark> marksOf(const SetUp& set, double motionFrequency)
{
    std::vector<Figure::Mark> marks;
    for (std::size_t n = 0; n < set.naturalFrequencies.size(); ++n)
    {
        marks.push_back({set.naturalFrequencies[n], "\u03c9" + std::to_string(n + 1), false});
    }
    if (motionFrequency > 0)
    {
        marks.push_back({motionFrequency, "motion", true});
    }
    return marks;
}

/// Where the axis of a panel's spectra ends: eight times the motion's or the first natural frequency, or else the
/// strongest line, and behind all marks.
double endOfAxis(const std::vector<Figure::Mark>& marks, double strongest)
{
    double last = 0;
    for (const Figure::Mark& mark : marks)
    {
        last = std::max(last, 1.6 * mark.at);
    }
    return std::max(last, 8 * (marks.empty() ? strongest : marks.back().ofMotion ? marks.back().at : marks.front().at));
}

/// The figure of a panel's spectra; without curves where none of its series moves.
Figure spectraOf(const Panel& panel, const std::vector<Figure::Mark>& marks)
{
    const bool composed = panel.unit.find(' ') != std::string::npos;
    const std::string square = composed ? "(" + panel.unit + ")^2 " : panel.unit.empty() ? "" : panel.unit + "^2 ";
    Figure figure{"angular frequency [rad/s]", withUnit("power density", square + "s/rad"), {}, marks, 0, 0};
    double highest = 0;
    for (const auto& curve : panel.curves)
    {
        if (curve.points.size() < Spectrum::fewest || !varies(curve.points))
        {
            continue;
        }
        const Spectrum spectrum(curve.points);
        // A run that is short against the periods marked has lines beyond them only.
        figure.xEnd =
            std::max({figure.xEnd, endOfAxis(marks, std::max(spectrum.strongest(), spectrum.step)), 8 * spectrum.step});
        highest = std::max(highest, *std::max_element(spectrum.density.begin(), spectrum.density.end()));
        TimeSeries line;
        for (std::size_t k = 1; k < spectrum.density.size(); ++k)
        {
            line.t.push_back(spectrum.omega(k));
            line.value.push_back(spectrum.density[k]);
        }
        figure.curves.push_back({curve.legend, line});
    }
    figure.logarithmFrom = 1e-6 * highest;
    for (auto& curve : figure.curves)
    {
        curve.points = thinned(curve.points.between(0, figure.xEnd));
    }
    figure.xEnd = std::min(figure.xEnd, figure.curves.empty() ? 0 : figure.curves.front().points.t.back());
    return figure;
}

} // namespace

void writeHistories(HtmlPage& page, const std::vector<SampledFile>& files, double from)
{
    page.section("histories", "Histories");
    if (files.empty())
    {
        page.paragraph("No samples: no function of system/controlDict has written to postProcessing.");
    }
    std::vector<std::string> still;
    page.beginRow();
    for (const SampledFile& file : files)
    {
        for (Panel& panel : panelsOf(file, from))
        {
            if (const std::string words = stillness(panel); !words.empty())
            {
                still.push_back(captionOf(file, panel) + ": " + words + ".");
                continue;
            }
            shorten(panel);
            for (auto& curve : panel.curves)
            {
                curve.points = thinned(curve.points);
            }
            const Figure figure{"time [s]", withUnit(panel.quantity, panel.unit), panel.curves, {}, 0, 0};
            page.picture("svg+xml", draw(figureTerminal, figure.script()), captionOf(file, panel));
        }
    }
    page.endRow();
    for (const std::string& words : still)
    {
        page.paragraph(words);
    }
}

void writeSpectra(
    HtmlPage& page, const std::vector<SampledFile>& files, double from, const SetUp& set, double motionFrequency
)
{
    page.section("spectra", "Spectra");
    const auto marks = marksOf(set, motionFrequency);
    std::vector<std::pair<std::string, std::string>> pictures;
    for (const SampledFile& file : files)
    {
        for (Panel& panel : panelsOf(file, from))
        {
            const Figure figure = spectraOf(panel, marks);
            if (!figure.curves.empty())
            {
                pictures.emplace_back(draw(figureTerminal, figure.script()), captionOf(file, panel));
            }
        }
    }
    if (pictures.empty())
    {
        page.paragraph("There is no varying series of " + std::to_string(Spectrum::fewest) + " samples or more.");
        return;
    }
    page.paragraph(
        "Power spectral densities of the histories: periodograms with Hann window, mean removed. The area below a "
        "curve is the mean square." +
        std::string(set.naturalFrequencies.empty() ? "" : " Dashed: the natural frequencies of linear theory.")
    );
    page.beginRow();
    for (const auto& [picture, caption] : pictures)
    {
        page.picture("svg+xml", picture, caption);
    }
    page.endRow();
}

} // namespace slosh
