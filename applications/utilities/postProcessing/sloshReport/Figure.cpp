// SPDX-License-Identifier: GPL-3.0-or-later
#include "Figure.hpp"

#include "contentOf.hpp"

#include "common/TemporaryFolder.hpp"
#include "common/runProgram.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

constexpr std::array<const char*, 8> colours = {"#0b5fa5", "#c4541a", "#2e8b57", "#8e44ad",
                                                "#555555", "#b8901a", "#1495a8", "#c2185b"};

} // namespace

TimeSeries thinned(const TimeSeries& series, std::size_t stretches)
{
    if (series.size() <= 2 * stretches)
    {
        return series;
    }
    TimeSeries fewer;
    const auto add = [&](std::size_t k)
    {
        fewer.t.push_back(series.t[k]);
        fewer.value.push_back(series.value[k]);
    };
    const double begin = series.t.front(), length = series.t.back() - begin;
    const auto stretchOf = [&](std::size_t k)
    { return static_cast<std::size_t>((series.t[k] - begin) / length * static_cast<double>(stretches)); };
    for (std::size_t k = 0; k < series.size();)
    {
        std::size_t low = k, high = k, end = k;
        for (; end < series.size() && stretchOf(end) == stretchOf(k); ++end)
        {
            low = series.value[end] < series.value[low] ? end : low;
            high = series.value[end] > series.value[high] ? end : high;
        }
        add(std::min(low, high));
        if (low != high)
        {
            add(std::max(low, high));
        }
        k = end;
    }
    return fewer;
}

std::string quoted(const std::string& text)
{
    std::string out = "'";
    for (const char c : text)
    {
        out += c == '\'' ? std::string("''") : c == '\n' ? std::string(" ") : std::string(1, c);
    }
    return out + "'";
}

std::string Figure::script() const
{
    std::ostringstream out;
    out.precision(7);
    for (std::size_t k = 0; k < curves.size(); ++k)
    {
        out << "$curve" << k << " << EOD\n";
        for (std::size_t i = 0; i < curves[k].points.size(); ++i)
        {
            out << curves[k].points.t[i] << " " << curves[k].points.value[i] << "\n";
        }
        out << "EOD\n";
    }
    // Names of curves stand above the figure, but where marks have theirs there.
    out << "set encoding utf8\nset grid lt 1 lw 0.5 lc rgb '#dddddd'\nset border 3 lc rgb '#555555'\n"
           "set tics nomirror\nset lmargin 10\nset rmargin 3\nset key noenhanced samplen 2 "
        << (marks.empty() ? "outside top center horizontal" : "inside top right vertical\nset tmargin 2.8")
        << "\nset xlabel " << quoted(xLabel) << " noenhanced\nset ylabel " << quoted(yLabel)
        << " noenhanced offset 0.5,0\n";
    if (xEnd > 0)
    {
        out << "set xrange [0:" << xEnd << "]\n";
    }
    if (logarithmFrom > 0)
    {
        out << "set logscale y\nset format y '10^{%T}'\nset yrange [" << logarithmFrom << ":*]\n";
    }
    for (const Mark& mark : marks)
    {
        if (xEnd > 0 && mark.at > xEnd)
        {
            continue;
        }
        const std::string colour = mark.ofMotion ? "'#c2185b'" : "'#444444'";
        out << "set arrow from first " << mark.at << ", graph 0 to first " << mark.at << ", graph "
            << (mark.ofMotion ? 1.09 : 1) << " nohead back dashtype " << (mark.ofMotion ? 4 : 2) << " lc rgb " << colour
            << "\nset label " << quoted(mark.name) << " noenhanced at first " << mark.at << ", graph "
            << (mark.ofMotion ? 1.13 : 1.04) << " center tc rgb " << colour << "\n";
    }
    out << "plot ";
    for (std::size_t k = 0; k < curves.size(); ++k)
    {
        out << (k > 0 ? ", " : "") << "$curve" << k << " using 1:2 with "
            << (curves[k].points.size() < 30 ? "linespoints pt 7 ps 0.5" : "lines") << " lw 1.4 lc rgb '"
            << colours.at(k % colours.size()) << "' dashtype " << (curves[k].dashed ? 2 : 1) << " title "
            << quoted(curves[k].legend);
    }
    out << "\n";
    return out.str();
}

std::string draw(const std::string& terminal, const std::string& script)
{
    const auto gnuplot = findProgram("gnuplot");
    if (!gnuplot)
    {
        throw CaseError("gnuplot not found (Debian packages gnuplot-nox, fonts-dejavu-core)");
    }
    const TemporaryFolder folder;
    writeFile(folder.path() / "script", "reset\nset terminal " + terminal + "\nset output 'picture'\n" + script);
    const Ended ended = runProgram(*gnuplot, {"script"}, folder.path(), "log");
    const std::string picture = contentOf(folder.path() / "picture");
    if (ended.status != 0 || picture.empty())
    {
        throw CaseError("gnuplot cannot draw:\n" + contentOf(folder.path() / "log"));
    }
    return picture;
}

} // namespace slosh
