// SPDX-License-Identifier: GPL-3.0-or-later
#include "uncertaintyText.hpp"

#include "costOfFinerSpacing.hpp"

#include "base/counted.hpp"
#include "base/numberText.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace slosh
{

namespace
{

constexpr int digitsOfFigure = 4, digitsOfUncertainty = 2, digitsOfSpacing = 3;

std::string withUnit(const FigureUncertainty& figure, const std::string& number)
{
    const std::string& unit = figure.comparison->unit;
    return unit.empty() ? number : number + " " + unit;
}

std::string figureText(const FigureUncertainty& figure, double value)
{
    return withUnit(figure, numberText(value, digitsOfFigure));
}

/// With two digits, or all those before the point.
std::string uncertaintyNumber(double value)
{
    const double digits = value > 0 && std::isfinite(value) ? std::floor(std::log10(value)) + 1 : 0;
    constexpr int most = 9;
    return numberText(value, std::clamp(static_cast<int>(digits), digitsOfUncertainty, most));
}

/// A share of the figure, or in its unit where it has no size.
std::string share(const FigureUncertainty& figure, double uncertainty)
{
    return figure.size() > 0 ? uncertaintyNumber(100 * uncertainty / figure.size()) + " %"
                             : withUnit(figure, uncertaintyNumber(uncertainty));
}

/// "20 periods", "5 members"
std::string samplesOfScatter(const FigureAtSpacing& at)
{
    return counted(at.count, at.rows.size() > 1 ? "member" : "period");
}

std::string orderText(const NumericalUncertainty& band, double schemeOrder)
{
    const std::string range = "0.5 to " + numberText(schemeOrder, digitsOfSpacing);
    std::string text = numberText(band.order, digitsOfSpacing);
    if (band.isOrderKept)
    {
        return text + ", within " + range;
    }
    const bool isSchemes = band.order > schemeOrder && band.order < schemeOrder + orderTolerance;
    text += isSchemes ? ", that of the scheme: fitted with " : ", outside " + range + ": fitted instead with ";
    for (const double p : band.fit.exponents)
    {
        text += (p == band.fit.exponents.front() ? "dx" : " and dx") +
                (p == 1 ? std::string() : "^" + numberText(p, digitsOfSpacing));
    }
    return text;
}

std::string scatterText(const FigureUncertainty& figure)
{
    const FigureAtSpacing& finest = figure.finest();
    if (!std::isfinite(finest.scatter))
    {
        return "unknown: the figure is a mean neither over periods (quantity meanPeak) nor over an ensemble";
    }
    return "+- " + share(figure, figure.band->scatter) + ", of which +- " + share(figure, finest.scatter) + " of " +
           samplesOfScatter(finest) + " and the rest by the fit";
}

/// U that is worth asking for next: the largest target below it, or half.
double nextUncertainty(const FigureUncertainty& figure, const Study& study)
{
    const double unit = figure.size() > 0 ? figure.size() : 1, now = figure.band->total();
    for (const double target : study.targets)
    {
        if (target * unit < now)
        {
            return target * unit;
        }
    }
    return now / 2;
}

/// The spacing where the fit's error is `ratio` of that of the finest; nothing down to a twentieth of that.
std::optional<double> spacingFor(double ratio, const FigureUncertainty& figure)
{
    constexpr double step = 0.998, finestTried = 0.05;
    const double finest = figure.finest().spacing;
    const RefinementFit& fit = figure.band->fit;
    const double error = ratio * fit.error(finest).norm();
    for (double dx = finest; dx > finestTried * finest; dx *= step)
    {
        if (fit.error(dx).norm() <= error)
        {
            return dx;
        }
    }
    return std::nullopt;
}

std::string needs(const FigureUncertainty& figure, const Study& study)
{
    const NumericalUncertainty& band = *figure.band;
    if (!(band.total() > 0))
    {
        return "";
    }
    const double wanted = nextUncertainty(figure, study);
    const std::string begin = "; +- " + share(figure, wanted) + " needs ";
    if (!band.isFollowed())
    {
        return begin + "more spacings: these figures follow no power of dx";
    }
    if (wanted <= band.scatter)
    {
        return begin + "more periods or members: the scatter alone is +- " + share(figure, band.scatter);
    }
    const double part = std::sqrt(wanted * wanted - band.scatter * band.scatter);
    const auto dx = spacingFor(part / band.discretisation, figure);
    if (!dx)
    {
        return begin + "another scheme: by this fit a spacing more than 20 times finer";
    }
    const double seconds = costOfFinerSpacing(*figure.figures.back().rows.front(), *figure.finest().rows.front(), *dx) *
                           static_cast<double>(figure.finest().rows.size());
    return begin + "about dx = " + lengthText(*dx) +
           (std::isfinite(seconds) ? " and " + duration(seconds) + " of CPU" : "");
}

std::string costOf(const FigureAtSpacing& at)
{
    return at.cpuSeconds > 0 ? ", " + duration(at.cpuSeconds) + " of CPU" : "";
}

} // namespace

std::string duration(double seconds)
{
    constexpr double minute = 60, hour = 3600;
    return seconds < 2 * minute ? numberText(seconds, 3) + " s"
           : seconds < 2 * hour ? numberText(seconds / minute, 3) + " min"
                                : numberText(seconds / hour, 3) + " h";
}

std::string lengthText(double metres)
{
    constexpr double largestInMillimetres = 0.1;
    return metres < largestInMillimetres ? numberText(1000 * metres, digitsOfSpacing) + " mm"
                                         : numberText(metres, digitsOfSpacing) + " m";
}

std::string fewSpacings(const Study& study, std::size_t count)
{
    return study.axesPlace + ": axes have " + counted(count, "spacing") + " with this figure; expected at least " +
           std::to_string(fewestSpacings) + " for an order and an uncertainty";
}

std::string uncertaintyTable(const FigureUncertainty& figure, const Study& study)
{
    const FigureAtSpacing& finest = figure.finest();
    const bool isSeries = figure.comparison->isSeries;
    std::ostringstream out;
    const auto line = [&](const std::string& name, const std::string& text)
    { out << "        " << std::left << std::setw(16) << name << text << "\n"; };
    out << "    the " << (isSeries ? "series" : "figure") << " itself, at " << counted(figure.figures.size(), "spacing")
        << (isSeries ? ", as a share of the variation of the reference" : "") << ":\n";
    if (!isSeries)
    {
        line("finest", figureText(figure, finest.figure) + " at dx = " + lengthText(finest.spacing));
    }
    if (figure.figures.size() > 1)
    {
        line(
            "last change", share(figure, figure.change) + ", from dx = " + lengthText(figure.figures[1].spacing) +
                               " to " + lengthText(finest.spacing)
        );
    }
    if (!figure.band)
    {
        line("uncertainty", "unknown: an order needs at least " + counted(fewestSpacings, "spacing"));
        return out.str();
    }
    const NumericalUncertainty& band = *figure.band;
    line("order", orderText(band, study.formalOrder));
    if (!isSeries)
    {
        line("extrapolated", figureText(figure, band.fit.limit(0)) + " at dx = 0");
    }
    line(
        "discretisation", "+- " + share(figure, band.discretisation) +
                              (band.isChange       ? ", the last change: the fit gives less"
                               : band.isFollowed() ? ", safety factor " + numberText(band.safetyFactor, digitsOfSpacing)
                                                   : ": the figures scatter more about the fit than they change")
    );
    if (!isSeries)
    {
        line("scatter", scatterText(figure));
    }
    line("together", "+- " + share(figure, band.total()) + ", 95 %");
    return out.str();
}

std::string uncertaintySentence(const FigureUncertainty& figure, const Study& study)
{
    if (figure.figures.empty())
    {
        return "is unknown: no finished run has it";
    }
    const FigureAtSpacing& finest = figure.finest();
    const std::string value = figure.comparison->isSeries ? "(series)" : figureText(figure, finest.figure);
    const std::string where = ", at dx = " + lengthText(finest.spacing) + costOf(finest);
    if (figure.band)
    {
        return value + " +- " + share(figure, figure.band->total()) + where + needs(figure, study);
    }
    const std::string change =
        figure.figures.size() > 1
            ? "; the change from dx = " + lengthText(figure.figures[1].spacing) + " is " + share(figure, figure.change)
            : "";
    return value + where + change + "; uncertainty unknown: " + fewSpacings(study, figure.figures.size());
}

} // namespace slosh
