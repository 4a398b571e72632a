// SPDX-License-Identifier: GPL-3.0-or-later
#include "map.hpp"

#include "base/numberText.hpp"
#include "dictionary/tokenize.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace slosh
{

namespace
{

/// Text in gnuplot's single quotes.
std::string gnuplotQuoted(const std::string& text)
{
    std::string out = "'";
    for (const char c : text)
    {
        out += c == '\'' ? std::string("''") : std::string(1, c);
    }
    return out + "'";
}

/// Where the values of an axis stand: at their numbers, or one after another where one is no number.
struct Scale
{
    explicit Scale(const SweepAxis& axis) : title(axis.title())
    {
        for (const auto& value : axis.values)
        {
            double number = 0;
            isNumeric = isNumber(value.label, number) && isNumeric;
            at.push_back(number);
            labels.push_back(value.label);
        }
        for (std::size_t k = 0; k < at.size() && !isNumeric; ++k)
        {
            at[k] = static_cast<double>(k);
        }
        sorted = at;
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    }

    /// The ends of the cell about a place: half-way to its neighbours.
    std::pair<double, double> cell(double place) const
    {
        const auto it = std::lower_bound(sorted.begin(), sorted.end(), place);
        const auto k = it - sorted.begin();
        const auto gap = [&](std::ptrdiff_t i) { return (sorted[i + 1] - *(sorted.begin() + i)) / 2; };
        const std::ptrdiff_t last = std::ssize(sorted) - 1;
        const double below = last == 0 ? 0.5 : gap(k > 0 ? k - 1 : 0),
                     above = last == 0 ? 0.5 : gap(k < last ? k : k - 1);
        return {place - below, place + above};
    }

    void write(std::ostream& out, const std::string& axis, double margin) const
    {
        const double low = cell(sorted.front()).first, high = cell(sorted.back()).second;
        const double from = margin > 0 ? sorted.front() - margin * (high - low) : low;
        const double to = margin > 0 ? sorted.back() + margin * (high - low) : high;
        out << "set " << axis << "label " << gnuplotQuoted(title) << " noenhanced"
            << "\nset " << axis << "range [" << numberText(from, 8) << ":" << numberText(to, 8) << "]\n";
        out << "set " << axis << "tics auto\n";
        if (!isNumeric || (margin == 0 && sorted.size() <= 15)) // a map has a cell about each value
        {
            for (std::size_t k = 0; k < at.size(); ++k)
            {
                out << "set " << axis << "tics " << (k == 0 ? "" : "add ") << "(" << gnuplotQuoted(labels[k]) << " "
                    << at[k] << ")\n";
            }
        }
    }

    std::string title;
    bool isNumeric = true;
    std::vector<double> at, sorted;
    std::vector<std::string> labels;
};

/// The axes that have more than one value, the first frequency in front: it stands along x.
std::vector<std::size_t> axesDrawn(const Sweep& sweep)
{
    std::vector<std::size_t> drawn;
    for (std::size_t k = 0; k < sweep.axes.size(); ++k)
    {
        if (sweep.axes[k].values.size() > 1)
        {
            drawn.push_back(k);
        }
    }
    const auto frequency =
        std::find_if(drawn.begin(), drawn.end(), [&](std::size_t k) { return sweep.axes[k].isFrequency; });
    if (frequency != drawn.end())
    {
        std::rotate(drawn.begin(), frequency, frequency + 1);
    }
    return drawn.empty() ? std::vector<std::size_t>{0} : drawn;
}

/// The natural frequencies of a case as they stand on an axis of frequencies; none on another.
std::vector<double> marksOf(const SweptCase& one, const SweepAxis& axis)
{
    std::vector<double> marks = axis.isFrequency ? one.facts.naturalFrequencies : std::vector<double>();
    const double of = marks.empty() || axis.naturalMode == 0 ? 1 : marks[axis.naturalMode - 1];
    std::transform(marks.begin(), marks.end(), marks.begin(), [&](double omega) { return omega / of; });
    return marks;
}

/// What stands in one panel, and how.
class Panel
{
public:
    Panel(const Sweep& sweep, const std::vector<CaseState>& states, std::size_t result)
        : sweep_(sweep), states_(states), result_(sweep.results[result]), index_(result), drawn_(axesDrawn(sweep)),
          xAxis_(drawn_.front())
    {
        for (const auto& axis : sweep.axes)
        {
            scales_.emplace_back(axis);
        }
    }

    bool isEmpty() const
    {
        return std::none_of(
            states_.begin(), states_.end(), [&](const CaseState& state) { return std::isfinite(figure(state).value); }
        );
    }

    void writeData(std::ostream& out) const { isMap() ? writeCells(out) : writeCurves(out); }

    void write(std::ostream& out) const
    {
        out << "unset arrow\nunset label\nset title " << gnuplotQuoted(result_.description) << " noenhanced\n";
        scales_[xAxis_].write(out, "x", isMap() ? 0 : 0.04);
        isMap() ? writeMap(out) : writePlot(out);
    }

private:
    /// Cells in colours with their numbers, white on dark and black on light ones.
    void writeMap(std::ostream& out) const
    {
        const bool isMarked = sweep_.axes[xAxis_].isFrequency;
        scales_[drawn_[1]].write(out, "y", 0);
        double lowest = INFINITY, highest = -INFINITY;
        for (const CaseState& state : states_)
        {
            if (std::isfinite(figure(state).value))
            {
                lowest = std::min(lowest, figure(state).value);
                highest = std::max(highest, figure(state).value);
            }
        }
        const std::string light = "$7 > " + numberText(lowest + 0.6 * (highest - lowest), 6);
        const std::string text = ":2:(sprintf('%.4g', $7)) with labels font ',11' textcolor rgb ";
        out << (isMarked ? "set xlabel " + gnuplotQuoted(scales_[xAxis_].title + ", dashed: natural frequencies") +
                               " noenhanced\n"
                         : "")
            << "set cblabel " << gnuplotQuoted(result_.title())
            << " noenhanced offset 1.5,0\nunset key\nunset grid\nset rmargin 13\nplot " << block("cells")
            << " using 1:2:3:4:5:6:7 with boxxyerror linecolor palette";
        out << ", \\\n     " << block("marks")
            << " using 1:2:(0):3 with vectors nohead linewidth 2 dashtype 2 linecolor rgb '#ff3030'";
        if (scales_[xAxis_].sorted.size() <= 8 && scales_[drawn_[1]].sorted.size() <= 20) // else they would overlap
        {
            out << ", \\\n     " << block("cells") << " using (" << light << " ? NaN : $1)" << text
                << "'white', \\\n     " << block("cells") << " using (" << light << " ? $1 : NaN)" << text << "'black'";
        }
        out << "\nset rmargin -1\n";
    }

    void writePlot(std::ostream& out) const
    {
        out << "set ylabel " << gnuplotQuoted(result_.title()) << " noenhanced\nset yrange [*:*]\nset ytics auto\n"
            << "set grid linetype 1 linewidth 0.5 linecolor rgb '#dddddd'\nset key tmargin center maxrows 3 samplen 2 "
               "noenhanced\nset offsets 0, 0, graph 0.05, graph 0.05\n";
        writeMarks(out);
        out << "plot ";
        std::size_t k = 0;
        for (const auto& [name, cases] : curves())
        {
            const std::string curve = block("curve" + std::to_string(k));
            const std::string line = " linetype " + std::to_string(k % 8 + 1);
            out << (k == 0 ? "" : ", \\\n     ");
            if (result_.hasReference)
            {
                out << curve << " using 1:4 with lines dashtype 2" << line << " title "
                    << (k == 0 ? gnuplotQuoted(result_.reference) : "''") << ", \\\n     ";
            }
            if (std::any_of(
                    cases.begin(), cases.end(),
                    [&](std::size_t i) { return std::isfinite(figure(states_[i]).uncertainty); }
                ))
            {
                out << curve << " using 1:2:3 with errorbars pointsize 0" << line << " notitle, \\\n     ";
            }
            out << curve << " using 1:2 with linespoints" << line << " pointtype " << 5 + 2 * (k % 5)
                << " pointsize 1.2 title " << gnuplotQuoted(name.empty() ? "cases" : name);
            ++k;
        }
        out << "\n";
    }

    const CaseState::Figure& figure(const CaseState& state) const { return state.figures[index_]; }
    bool isMap() const { return drawn_.size() == 2; }
    std::string block(const std::string& what) const { return "$result" + std::to_string(index_) + what; }
    double place(const SweptCase& one, std::size_t axis) const { return scales_[axis].at[one.setting.values[axis]]; }

    /// The cases by the values of all axes but that along x, in their order.
    std::vector<std::pair<std::string, std::vector<std::size_t>>> curves() const
    {
        std::vector<std::pair<std::string, std::vector<std::size_t>>> all;
        for (std::size_t i = 0; i < sweep_.cases.size(); ++i)
        {
            std::string name;
            for (auto axis = drawn_.begin() + 1; axis != drawn_.end(); ++axis)
            {
                const SweepAxis& other = sweep_.axes[*axis];
                name += (name.empty() ? "" : ", ") + other.name + " " +
                        withUnit(other.values[sweep_.cases[i].setting.values[*axis]].label, other.unit);
            }
            auto found = std::find_if(all.begin(), all.end(), [&](const auto& curve) { return curve.first == name; });
            if (found == all.end())
            {
                found = all.insert(all.end(), {name, {}});
            }
            found->second.push_back(i);
        }
        for (auto& curve : all)
        {
            std::stable_sort(
                curve.second.begin(), curve.second.end(),
                [&](std::size_t a, std::size_t b)
                { return place(sweep_.cases[a], xAxis_) < place(sweep_.cases[b], xAxis_); }
            );
        }
        return all;
    }

    void writeCurves(std::ostream& out) const
    {
        std::size_t k = 0;
        for (const auto& [name, cases] : curves())
        {
            out << block("curve" + std::to_string(k++)) << " << EOD\n";
            for (const std::size_t i : cases)
            {
                const CaseState::Figure& one = figure(states_[i]);
                if (std::isfinite(one.value))
                {
                    out << place(sweep_.cases[i], xAxis_) << " " << one.value << " " << one.uncertainty << " "
                        << one.reference << "\n";
                }
            }
            out << "EOD\n";
        }
    }

    void writeCells(std::ostream& out) const
    {
        const std::size_t yAxis = drawn_[1];
        out << block("cells") << " << EOD\n";
        std::map<double, std::vector<double>> marks;
        for (std::size_t i = 0; i < sweep_.cases.size(); ++i)
        {
            const SweptCase& one = sweep_.cases[i];
            const double x = place(one, xAxis_), y = place(one, yAxis);
            marks[y] = marksOf(one, sweep_.axes[xAxis_]);
            if (std::isfinite(figure(states_[i]).value))
            {
                const auto [left, right] = scales_[xAxis_].cell(x);
                const auto [low, high] = scales_[yAxis].cell(y);
                out << x << " " << y << " " << left << " " << right << " " << low << " " << high << " "
                    << figure(states_[i]).value << "\n";
            }
        }
        out << "EOD\n" << block("marks") << " << EOD\n";
        for (const auto& [y, frequencies] : marks)
        {
            const auto [low, high] = scales_[yAxis].cell(y);
            for (const double frequency : frequencies)
            {
                out << frequency << " " << low << " " << high - low << "\n";
            }
            if (frequencies.empty())
            {
                out << "NaN NaN NaN\n"; // a block without a line is refused
            }
        }
        out << "EOD\n";
    }

    /// A line at each natural frequency that a case of the panel has.
    void writeMarks(std::ostream& out) const
    {
        std::set<std::pair<std::string, std::string>> drawn;
        for (const SweptCase& one : sweep_.cases)
        {
            const auto marks = marksOf(one, sweep_.axes[xAxis_]);
            for (std::size_t n = 0; n < marks.size(); ++n)
            {
                const std::string at = numberText(marks[n], 3), name = "ω" + std::to_string(n + 1);
                const Scale& x = scales_[xAxis_];
                if (marks[n] < x.sorted.front() || marks[n] > x.sorted.back() || !drawn.insert({name, at}).second)
                {
                    continue;
                }
                out << "set arrow from first " << marks[n] << ", graph 0 to first " << marks[n]
                    << ", graph 1 nohead back dashtype 3 linecolor rgb '#444444'\nset label " << gnuplotQuoted(name)
                    << " at first " << marks[n] << ", graph 1 offset 0.3,-0.8\n";
            }
        }
    }

    const Sweep& sweep_;
    const std::vector<CaseState>& states_;
    const Result& result_;
    std::size_t index_;
    std::vector<std::size_t> drawn_;
    std::size_t xAxis_;
    std::vector<Scale> scales_;
};

} // namespace

std::string mapScript(const std::string& title, const Sweep& sweep, const std::vector<CaseState>& states)
{
    std::vector<Panel> panels;
    for (std::size_t k = 0; k < sweep.results.size(); ++k)
    {
        Panel panel(sweep, states, k);
        if (!panel.isEmpty())
        {
            panels.push_back(panel);
        }
    }
    if (panels.empty())
    {
        return "";
    }
    std::ostringstream out;
    out << "# The results of a sweep, written by sloshSweep. In this folder: gnuplot sweep.gp\n"
           "# Columns of a curve: place along x, result, uncertainty, reference; of cells: place, ends along x and y, "
           "result\nreset\nset encoding utf8\nset datafile missing 'nan'\n";
    for (const Panel& panel : panels)
    {
        panel.writeData(out);
    }
    out << "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n"
           "set style fill solid 1 noborder\n";
    const std::size_t columns = std::min<std::size_t>(panels.size(), 2), rows = (panels.size() + columns - 1) / columns;
    const std::string size = std::to_string(900 * columns) + "," + std::to_string(580 * rows);
    for (const std::string format : {"svg", "png"})
    {
        out << "\nset terminal "
            << (format == "svg" ? "svg size " + size + " background rgb 'white'" : "pngcairo size " + size)
            << " font 'DejaVu Sans,14' linewidth 1.5\nset output 'sweep." << format << "'\nset multiplot layout "
            << rows << "," << columns << " title " << gnuplotQuoted(title) << " noenhanced\n";
        for (const Panel& panel : panels)
        {
            panel.write(out);
        }
        out << "unset multiplot\nunset output\n";
    }
    return out.str();
}

} // namespace slosh
