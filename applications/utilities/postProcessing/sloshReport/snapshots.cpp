// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshots.hpp"

#include "Figure.hpp"

#include "particles/changeFrame.hpp"
#include "particles/particleFiles.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

/// What is seen: horizontal and vertical direction, and the one looked along, -1 where nothing is cut.
struct View
{
    int across = 0, up = 2;
    int cut = -1;
};

View viewOf(const Tank& tank)
{
    if (tank.dim() == 2)
    {
        return {tank.directions()[0], tank.directions()[1], -1};
    }
    const Vec size = tank.box().sizes();
    return size.x() >= size.y() ? View{0, 2, 1} : View{1, 2, 0};
}

/// Points of one time, in the plane that is seen.
struct Seen
{
    std::string time;
    double spacing = 0;
    std::vector<Vec> liquid, walls;
    std::vector<double> p;
};

Seen look(const Case& theCase, const Tank& tank, const View& view, const TimeDirectory& time)
{
    TimeState state;
    Particles particles = readTime(theCase, time.name, state);
    changeFrame(particles, state.solverFrame(), Frame::inertial);
    Seen seen;
    seen.time = time.name;
    seen.spacing = particles.spacing;
    const Vec middle = tank.box().center();
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
    {
        const Vec& x = particles.r[i];
        if (view.cut >= 0 &&
            std::abs(state.tank.pointToTank(x)[view.cut] - middle[view.cut]) > particles.spacing * (1 + 1e-9))
        {
            continue;
        }
        if (i < particles.nFluid)
        {
            seen.liquid.push_back(x);
            seen.p.push_back(particles.p[i]);
        }
        else
        {
            seen.walls.push_back(x);
        }
    }
    return seen;
}

/// The value that a share of all lies below.
double quantile(std::vector<double> values, double share)
{
    if (values.empty())
    {
        return 0;
    }
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[k];
}

/// The next round number up.
double roundedUp(double value)
{
    const double decade = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 2.5, 5.0})
    {
        if (value <= step * decade * (1 + 1e-12))
        {
            return step * decade;
        }
    }
    return 10 * decade;
}

} // namespace

std::vector<TimeDirectory> spread(const std::vector<TimeDirectory>& times, std::size_t count)
{
    if (times.size() <= count)
    {
        return times;
    }
    std::vector<TimeDirectory> some;
    for (std::size_t k = 1; k <= count; ++k)
    {
        some.push_back(times[k * (times.size() - 1) / count]);
    }
    return some;
}

std::vector<SnapshotPicture>
snapshotPictures(const Case& theCase, const Tank& tank, const std::vector<TimeDirectory>& times)
{
    const View view = viewOf(tank);
    std::vector<Seen> all;
    std::vector<double> pressures;
    BoundingBox box;
    for (const TimeDirectory& time : times)
    {
        all.push_back(look(theCase, tank, view, time));
        pressures.insert(pressures.end(), all.back().p.begin(), all.back().p.end());
        for (const auto* points : {&all.back().liquid, &all.back().walls})
        {
            for (const Vec& x : *points)
            {
                box.extend(x);
            }
        }
    }
    std::vector<SnapshotPicture> pictures;
    if (box.isEmpty())
    {
        return pictures;
    }
    const double lowest = std::min(0.0, quantile(pressures, 0.05)),
                 highest = quantile(pressures, 0.95); // beyond: spray
    const double reach = roundedUp(std::max({highest, -lowest, 1.0}));
    const double low = lowest < -0.05 * reach ? -reach : 0;
    const double unit = reach < 1e4 ? 1 : 1000; // as wide numbers as there is room for
    const double margin = 2 * all.front().spacing;
    const double across = box.sizes()[view.across] + 2 * margin, up = box.sizes()[view.up] + 2 * margin;
    // Pixels: of a metre, of the picture with room for axes and scale, of what is left of them, right, below and above.
    const double metre = std::min(570 / across, 480 / up), left = 75, right = 135, below = 55, above = 15;
    const double width = std::max(metre * across, 120.0) + left + right,
                 height = std::max(metre * up, 120.0) + below + above;
    std::ostringstream terminal, axes;
    axes.precision(7);
    terminal << "pngcairo size " << std::lround(width) << "," << std::lround(height) << " font 'DejaVu Sans,11'";
    axes << "set size ratio -1\nset lmargin at screen " << left / width << "\nset rmargin at screen "
         << 1 - right / width << "\nset bmargin at screen " << below / height << "\nset tmargin at screen "
         << 1 - above / height << "\nset xrange [" << box.min()[view.across] - margin << ":"
         << box.max()[view.across] + margin << "]\nset yrange [" << box.min()[view.up] - margin << ":"
         << box.max()[view.up] + margin << "]\nset xtics " << roundedUp(45 / metre) << "\nset cbrange [" << low / unit
         << ":" << reach / unit
         << "]\nset palette defined (0 '#08306b', 1 '#2171b5', 2 '#6baed6', 3 '#fdd49e', 4 '#ef6548', 5 '#990000')\n"
            "set cblabel 'pressure ["
         << (unit > 1 ? "kPa" : "Pa") << "]' offset 1.5,0\nset xlabel '"
         << "xyz"[view.across] << " [m]'\nset ylabel '"
         << "xyz"[view.up]
         << " [m]'\nset tics nomirror\nset border 3 lc rgb '#555555'\nset style fill solid noborder\nunset key\n";
    for (const Seen& seen : all)
    {
        std::ostringstream script;
        script.precision(7);
        const auto block =
            [&](const std::string& name, const std::vector<Vec>& points, const std::vector<double>& values)
        {
            script << name << " << EOD\n";
            for (std::size_t i = 0; i < points.size(); ++i)
            {
                script << points[i][view.across] << " " << points[i][view.up] << " "
                       << (i < values.size() ? values[i] / unit : 0) << "\n";
            }
            script << "EOD\n";
        };
        block("$liquid", seen.liquid, seen.p);
        block("$walls", seen.walls, {});
        script << axes.str() << "plot NaN notitle";
        const double radius = 0.65 * seen.spacing;
        if (!seen.walls.empty())
        {
            script << ", $walls using 1:2:(" << radius << ") with circles lc rgb '#b9c0c8'";
        }
        if (!seen.liquid.empty())
        {
            script << ", $liquid using 1:2:(" << radius << "):3 with circles lc palette";
        }
        script << "\n";
        pictures.push_back(
            {draw(terminal.str(), script.str()),
             "t = " + seen.time + " s" + (view.cut < 0 ? "" : ", a slice through the middle")}
        );
    }
    return pictures;
}

} // namespace slosh
