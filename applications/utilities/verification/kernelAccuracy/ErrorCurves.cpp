// SPDX-License-Identifier: GPL-3.0-or-later
#include "ErrorCurves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

namespace slosh
{

namespace
{

using Point = ErrorCurve::Point;
using Value = std::function<double(const Point&)>;

/// Smallest and largest of a value along a curve.
std::pair<double, double> extent(const ErrorCurve& curve, const Value& value)
{
    double low = value(curve.points.front()), high = low;
    for (const auto& point : curve.points)
    {
        low = std::min(low, value(point));
        high = std::max(high, value(point));
    }
    return {low, high};
}

/// The rows of two values a kernel, under the names of the kernels.
void appendRows(std::ostream& out, const ErrorCurves& all, const std::string& title, const Value& f, const Value& dfdx)
{
    out << "\n    " << title << "\n" << std::setw(10) << "" << std::right;
    for (const auto& curve : all.curves)
    {
        out << std::setw(24) << curve.kernel.name();
    }
    out << "\n" << std::setw(10) << "d/dx";
    for (std::size_t k = 0; k < all.curves.size(); ++k)
    {
        out << std::setw(14) << "f" << std::setw(10) << "df/dx";
    }
    out << "\n" << std::fixed;
    for (std::size_t i = 0; i < all.dByDx.size(); ++i)
    {
        out << std::setw(10) << std::setprecision(3) << all.dByDx[i] << std::setprecision(5);
        for (const auto& curve : all.curves)
        {
            out << std::setw(14) << f(curve.points[i]) << std::setw(10) << dfdx(curve.points[i]);
        }
        out << "\n";
    }
    out << std::defaultfloat;
}

void appendEdges(std::ostream& out, const ErrorCurves& all)
{
    for (const auto& curve : all.curves)
    {
        for (std::size_t i = 0; i < all.dByDx.size(); ++i)
        {
            if (const int n = curve.points[i].onEdge; n > 0)
            {
                out << "    " << curve.kernel.name() << ", d/dx = " << all.dByDx[i] << ": " << n
                    << (n == 1 ? " point lies" : " points lie")
                    << " on the edge of the support; rounding decides whether they count\n";
            }
        }
    }
}

} // namespace

double Moments::deviation() const
{
    return n_ > 1 ? std::sqrt(squares_ / static_cast<double>(n_ - 1)) : 0;
}

void ErrorCurve::add(std::size_t point, const KernelErrors& reference, const KernelErrors& loop)
{
    Point& at = points[point];
    at.f.add(reference.f);
    at.dfdx.add(reference.dfdx);
    at.unity.add(reference.unity);
    at.neighbours.add(reference.neighbours);
    at.loopF.add(loop.f);
    at.loopDfdx.add(loop.dfdx);
    at.onEdge = std::max(at.onEdge, reference.onEdge);
    differenceF = std::max(differenceF, std::abs(loop.f - reference.f));
    differenceDfdx = std::max(differenceDfdx, std::abs(loop.dfdx - reference.dfdx));
}

std::string ErrorCurves::table() const
{
    std::ostringstream out;
    out << description << "\n";
    const std::string mean = perturbed ? "mean error" : "error";
    appendRows(
        out, *this, mean + ", double precision", [](const Point& p) { return p.f.mean(); },
        [](const Point& p) { return p.dfdx.mean(); }
    );
    if (perturbed)
    {
        appendRows(
            out, *this, "standard deviation, double precision", [](const Point& p) { return p.f.deviation(); },
            [](const Point& p) { return p.dfdx.deviation(); }
        );
    }
    appendRows(
        out, *this, mean + ", the solver's pair loop in single precision",
        [](const Point& p) { return p.loopF.mean(); }, [](const Point& p) { return p.loopDfdx.mean(); }
    );

    out << "\n    " << std::left << std::setw(18) << "kernel" << std::right << std::setw(32)
        << "largest difference of the loop:" << std::setw(26) << (perturbed ? "mean " : "") + std::string("sum W V - 1")
        << std::setw(16) << "neighbours"
        << "\n    " << std::setw(34) << "f" << std::setw(16) << "df/dx"
        << "\n";
    for (const auto& curve : curves)
    {
        const auto unity = extent(curve, [](const Point& p) { return p.unity.mean(); });
        const auto neighbours = extent(curve, [](const Point& p) { return p.neighbours.mean(); });
        out << "    " << std::left << std::setw(18) << curve.kernel.name() << std::right << std::scientific
            << std::setprecision(1) << std::setw(16) << curve.differenceF << std::setw(16) << curve.differenceDfdx
            << std::setprecision(2) << std::setw(13) << unity.first << " ..." << std::setw(10) << unity.second
            << std::fixed << std::setprecision(perturbed ? 1 : 0) << std::setw(7) << neighbours.first << " ..."
            << std::setw(6) << neighbours.second << std::defaultfloat << "\n";
    }
    if (perturbed)
    {
        out << "    standard error of a mean: about (standard deviation)/sqrt(samples)\n";
    }
    appendEdges(out, *this);
    return out.str();
}

std::string ErrorCurves::file() const
{
    std::vector<std::pair<std::string, Value>> columns = {
        {"f", [](const Point& p) { return p.f.mean(); }},
        {"dfdx", [](const Point& p) { return p.dfdx.mean(); }},
        {"sumWV-1", [](const Point& p) { return p.unity.mean(); }},
        {"neighbours", [](const Point& p) { return p.neighbours.mean(); }},
        {"loopF", [](const Point& p) { return p.loopF.mean(); }},
        {"loopDfdx", [](const Point& p) { return p.loopDfdx.mean(); }}};
    if (perturbed)
    {
        columns.insert(
            columns.end(), {{"deviationF", [](const Point& p) { return p.f.deviation(); }},
                            {"deviationDfdx", [](const Point& p) { return p.dfdx.deviation(); }},
                            {"deviationSumWV", [](const Point& p) { return p.unity.deviation(); }}}
        );
    }
    std::ostringstream out;
    out << "# " << description << "\n"
        << "# Errors (sum - exact" << (perturbed ? ", means over the samples" : "")
        << "): f [m^2], dfdx [m], sumWV-1 in double precision, loopF and loopDfdx of the solver's pair loop\n"
        << "#" << std::setw(9) << "d/dx";
    for (const auto& curve : curves)
    {
        for (const auto& column : columns)
        {
            out << " " << std::setw(16) << curve.kernel.name() + ":" + column.first;
        }
    }
    out << "\n";
    for (std::size_t i = 0; i < dByDx.size(); ++i)
    {
        out << std::defaultfloat << std::setprecision(9) << std::setw(10) << dByDx[i] << std::scientific;
        for (const auto& curve : curves)
        {
            for (const auto& column : columns)
            {
                const auto width = std::max<std::size_t>(16, curve.kernel.name().size() + column.first.size() + 1);
                out << " " << std::setw(static_cast<int>(width)) << column.second(curve.points[i]);
            }
        }
        out << "\n";
    }
    return out.str();
}

} // namespace slosh
