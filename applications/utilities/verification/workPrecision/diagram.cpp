// SPDX-License-Identifier: GPL-3.0-or-later
#include "diagram.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace slosh
{

namespace
{

bool canBeDrawn(const Row& row)
{
    return row.hasError() && row.run->outcome.cpuSeconds > 0;
}

/// Text in gnuplot's single quotes.
std::string quoted(const std::string& text)
{
    std::string out = "'";
    for (const char c : text)
    {
        out += c == '\'' ? std::string("''") : std::string(1, c);
    }
    return out + "'";
}

std::string blockName(std::size_t table, const std::string& what)
{
    return "$table" + std::to_string(table) + what;
}

/// Blocks of CPU seconds, error (percent where it is a share), spacing: one for each scheme, for the front, for its
/// labels.
void writeData(std::ostream& out, const ErrorTable& table, std::size_t index)
{
    const double scale = table.comparison->isShare ? 100 : 1;
    const auto write = [&](const std::string& name, const std::vector<const Row*>& rows)
    {
        out << name << " << EOD\n";
        for (const Row* row : rows)
        {
            if (canBeDrawn(*row))
            {
                out << row->run->outcome.cpuSeconds << " " << scale * row->error << " " << std::setprecision(3)
                    << row->spacing << std::setprecision(6) << "\n";
            }
        }
        out << "EOD\n";
    };
    const auto schemes = table.schemes();
    for (std::size_t s = 0; s < schemes.size(); ++s)
    {
        write(blockName(index, "scheme" + std::to_string(s)), table.rowsOf(schemes[s]));
    }
    const auto front = table.paretoFront();
    write(blockName(index, "front"), front);
    // Where several in a row have the same spacing, the last and best says it for all.
    std::vector<const Row*> labelled;
    for (std::size_t k = 0; k < front.size(); ++k)
    {
        if (k + 1 == front.size() || front[k + 1]->spacing != front[k]->spacing)
        {
            labelled.push_back(front[k]);
        }
    }
    write(blockName(index, "labels"), labelled);
}

/// "(2, 3, 5)": round numbers between two limits, the denser the nearer these are.
std::string tics(double low, double high)
{
    const double range = high / low;
    const std::vector<double> mantissas = range < 10     ? std::vector<double>{1, 1.5, 2, 3, 4, 5, 7}
                                          : range < 1000 ? std::vector<double>{1, 2, 5}
                                                         : std::vector<double>{1};
    std::ostringstream out;
    for (double decade = std::pow(10, std::floor(std::log10(low))); decade < high; decade *= 10)
    {
        for (const double mantissa : mantissas)
        {
            if (const double tic = mantissa * decade; tic >= low && tic <= high)
            {
                out << (out.tellp() == 0 ? "(" : ", ") << tic;
            }
        }
    }
    return out.tellp() == 0 ? "auto" : out.str() + ")";
}

/// Decades of errors in a panel: what is still smaller stands at 'less', lest all else is pressed together.
constexpr double decades = 5;

/// Ranges with room for the labels, and the targets inside them.
void writePanel(std::ostream& out, const Study& study, const ErrorTable& table, std::size_t index)
{
    const double scale = table.comparison->isShare ? 100 : 1;
    double cheapest = INFINITY, dearest = 0, best = INFINITY, worst = 0;
    for (const Row& row : table.rows)
    {
        if (canBeDrawn(row))
        {
            const double cpu = row.run->outcome.cpuSeconds, error = scale * row.error;
            cheapest = std::min(cheapest, cpu);
            dearest = std::max(dearest, cpu);
            best = std::min(best, error);
            worst = std::max(worst, error);
        }
    }
    for (const double target : study.targets)
    {
        // A target just below the best is worth seeing, one far below would press all else together.
        best = scale * target > best / 3 ? std::min(best, scale * target) : best;
    }
    const double edge = worst * std::pow(10, -decades);
    const bool cut = best < edge;
    best = std::max(best, edge);
    const double low = best / (cut ? 4 : 1.5), high = worst * 1.5, left = cheapest / 4, right = dearest * 1.6;
    out << "set title " << quoted(table.comparison->description + ", error against " + table.comparison->source)
        << " noenhanced\nset xrange [" << left << ":" << right << "]\nset xtics " << tics(left, right)
        << "\nset yrange [" << low << ":" << high << "]\nset ytics " << tics(cut ? 2 * best : low, high) << "\n";
    if (cut)
    {
        out << "set ytics add ('less' " << best << ")\n";
    }
    out << "set ylabel 'error" << (table.comparison->isShare ? " [%]" : "") << "'\nshown(error) = error < " << best
        << " ? " << best << " : error\nunset arrow\n";
    for (const double target : study.targets)
    {
        if (scale * target > low && scale * target < high)
        {
            out << "set arrow from graph 0, first " << scale * target << " to graph 1, first " << scale * target
                << " nohead back dashtype 3 linecolor rgb '#444444'\n";
        }
    }
    out << "plot " << blockName(index, "front")
        << " using 1:(shown($2)) with lines linewidth 8 linecolor rgb '#f0d9a8' title 'Pareto front'";
    const auto schemes = table.schemes();
    for (std::size_t s = 0; s < schemes.size(); ++s)
    {
        const auto rows = table.rowsOf(schemes[s]);
        if (std::any_of(rows.begin(), rows.end(), [](const Row* row) { return canBeDrawn(*row); }))
        {
            out << ", \\\n     " << blockName(index, "scheme" + std::to_string(s))
                << " using 1:(shown($2)) with linespoints linetype " << s + 1 << " pointtype " << 5 + 2 * (s % 5)
                << " pointsize 1.2 title " << quoted(schemes[s] == "-" ? "runs" : schemes[s]) << " noenhanced";
        }
    }
    out << ", \\\n     " << blockName(index, "labels")
        << " using 1:(shown($2)):(sprintf('dx = %g m', $3)) with labels offset -0.8,-0.8 right font ',11' notitle\n";
}

} // namespace

std::string diagramScript(const std::string& title, const Study& study, const std::vector<ErrorTable>& tables)
{
    std::vector<const ErrorTable*> drawn;
    for (const ErrorTable& table : tables)
    {
        if (std::any_of(table.rows.begin(), table.rows.end(), canBeDrawn))
        {
            drawn.push_back(&table);
        }
    }
    if (drawn.empty())
    {
        return "";
    }
    std::ostringstream out;
    out << "# Error against run time, written by workPrecision. In this folder: gnuplot workPrecision.gp\n"
           "# Columns: CPU seconds, error, spacing [m]\nreset\n";
    for (std::size_t k = 0; k < drawn.size(); ++k)
    {
        writeData(out, *drawn[k], k);
    }
    out << "set logscale xy\nset grid linetype 1 linewidth 0.5 linecolor rgb '#dddddd'\n"
           "set xlabel 'CPU time [s]'\nset format '%g'\nset key outside right top samplen 2\n";
    const std::string size = std::to_string(1000 * drawn.size()) + ",650";
    for (const std::string format : {"svg", "png"})
    {
        out << "\nset terminal "
            << (format == "svg" ? "svg size " + size + " background rgb 'white'" : "pngcairo size " + size)
            << " font 'DejaVu Sans,14' linewidth 1.5\nset output 'workPrecision." << format
            << "'\nset multiplot layout 1," << drawn.size() << " title " << quoted(title) << " noenhanced\n";
        for (std::size_t k = 0; k < drawn.size(); ++k)
        {
            writePanel(out, study, *drawn[k], k);
        }
        out << "unset multiplot\nunset output\n";
    }
    return out.str();
}

} // namespace slosh
