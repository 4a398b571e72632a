// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.hpp"

#include "Convergence.hpp"
#include "base/numberText.hpp"
#include "costOfFinerSpacing.hpp"
#include "uncertaintyText.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

std::string number(double value, int digits = 3)
{
    return numberText(value, digits);
}

/// "particleSpacing=0.02_alpha=0.01 with 4.2 % in 7.1 s of CPU"
std::string shown(const Row& row, const Comparison& comparison)
{
    return row.run->setting.name + ", " + errorText(comparison, row.error) + " in " +
           duration(row.run->outcome.cpuSeconds) + " of CPU";
}

/// The uncertainty of each family of a table, in the order of families().
using Uncertainties = std::vector<FigureUncertainty>;

Uncertainties uncertaintiesOf(const ErrorTable& table, const Study& study)
{
    Uncertainties all;
    for (const auto& family : table.families())
    {
        all.push_back(figureUncertainty(table.rowsOfFamily(family), *table.comparison, study.formalOrder));
    }
    return all;
}

/// What is missing where no run has an error, and where to add it.
std::string whyNoError(const Study& study, const ErrorTable& table, const Uncertainties& uncertainties)
{
    const auto isKnown = [](const Row& row) { return row.run->outcome.finished() && std::isfinite(row.figure); };
    if (std::none_of(table.rows.begin(), table.rows.end(), [](const Row& row) { return row.run->outcome.finished(); }))
    {
        return "no error: all runs have failed, for the reasons below";
    }
    if (std::none_of(table.rows.begin(), table.rows.end(), isKnown))
    {
        return "no error: no run has this figure; " + study.comparisonsPlace +
               ": expected samples and a quantity that the runs have (log.compareSamples in their folders)";
    }
    switch (table.comparison->reference)
    {
    case Comparison::Reference::richardson:
    {
        std::size_t most = 0;
        for (const auto& figure : uncertainties)
        {
            most = std::max(most, figure.figures.size());
        }
        return "no error against richardson: " + fewSpacings(study, most);
    }
    case Comparison::Reference::finest:
    case Comparison::Reference::run:
        return "no error against a run: no other run has a figure to compare with it; " + study.axesPlace +
               ": expected one more value at least";
    case Comparison::Reference::independent:
        break;
    }
    return "no error: there is no reference for this figure; " + study.comparisonsPlace + ": expected a reference";
}

/// Which run reaches each target at least cost: the first of the front that does.
void sayTargets(std::ostream& out, const Study& study, const ErrorTable& table, const Uncertainties& uncertainties)
{
    const Comparison& comparison = *table.comparison;
    const auto front = table.paretoFront();
    if (front.empty())
    {
        out << "    " << whyNoError(study, table, uncertainties) << "\n";
        return;
    }
    for (const double target : study.targets)
    {
        const auto reached =
            std::find_if(front.begin(), front.end(), [&](const Row* row) { return row->error <= target; });
        out << "    " << errorText(comparison, target) << ": "
            << (reached != front.end() ? shown(**reached, comparison) + " is the cheapest"
                                       : "reached by none; the best is " + shown(*front.back(), comparison))
            << "\n";
    }
    out << "    Pareto front, cheapest first:\n";
    for (const Row* row : front)
    {
        out << "        " << shown(*row, comparison) << "\n";
    }
}

/// For each other program: which of our runs that are no further off than its best is the cheapest.
void sayOutside(std::ostream& out, const Study& study, const ErrorTable& table)
{
    const Comparison& comparison = *table.comparison;
    const auto isOutside = [&](const Row& row)
    {
        return std::any_of(
            study.outside.begin(), study.outside.end(),
            [&](const OutsideRun& outside) { return outside.name == row.run->setting.name; }
        );
    };
    const auto cheaper = [](const Row* a, const Row* b)
    { return a == nullptr || b->run->outcome.cpuSeconds < a->run->outcome.cpuSeconds ? b : a; };
    for (const auto& program : table.schemes())
    {
        const Row *best = nullptr, *ours = nullptr;
        for (const Row* row : table.rowsOf(program))
        {
            if (isOutside(*row) && row->hasError() && (best == nullptr || row->error < best->error))
            {
                best = row;
            }
        }
        if (best == nullptr)
        {
            continue;
        }
        for (const Row& row : table.rows)
        {
            if (!isOutside(row) && row.hasError() && row.error <= best->error)
            {
                ours = cheaper(ours, &row);
            }
        }
        out << "    " << program << " at its best: " << shown(*best, comparison) << "; ";
        if (ours == nullptr)
        {
            out << "no run of SloshSPH is as accurate\n";
            continue;
        }
        out << "the cheapest run of SloshSPH at least as accurate: " << shown(*ours, comparison) << ", "
            << number(best->run->outcome.cpuSeconds / ours->run->outcome.cpuSeconds, 2) << " times cheaper\n";
    }
}

/// By the fitted power within the spacings that were run, else by costOfFinerSpacing.
double cpuSecondsAt(const Convergence& convergence, double dx)
{
    const Row &coarsest = *convergence.rows.front(), &finest = *convergence.rows.back();
    const double finer = dx < finest.spacing ? costOfFinerSpacing(coarsest, finest, dx) : Outcome::unknown;
    return std::isfinite(finer) ? finer : convergence.cpuSeconds ? (*convergence.cpuSeconds)(dx) : Outcome::unknown;
}

/// What spacing and time each target needs by the fitted powers.
void sayNeeds(std::ostream& out, const Study& study, const Comparison& comparison, const Convergence& convergence)
{
    const PowerLaw& law = *convergence.error;
    const auto power = [](const PowerLaw& fitted)
    {
        return "dx^" + number(fitted.p) +
               (std::isfinite(fitted.standardError) ? " (+- " + number(fitted.standardError, 2) + ")" : "");
    };
    out << "    error ~ " << power(law);
    if (convergence.cpuSeconds)
    {
        out << ", CPU time ~ " << power(*convergence.cpuSeconds);
    }
    out << ", fitted to the runs from dx = " << number(convergence.rows.front()->spacing) << " m down\n";
    if (!(law.p > 0))
    {
        out << "    no spacing reaches a smaller error: the error does not decrease with the spacing\n";
        return;
    }
    const Row& last = *convergence.rows.back();
    for (const double target : study.targets)
    {
        out << "    " << errorText(comparison, target) << " needs ";
        if (convergence.floor && target < last.error)
        {
            out << "more than a finer spacing: the error levels off at " << errorText(comparison, last.error) << "\n";
            continue;
        }
        const double dx = law.inverse(target);
        if (dx < last.spacing / 20)
        {
            out << "another scheme: by this power law a grid more than 20 times finer than any run\n";
            continue;
        }
        out << "dx = " << number(dx) << " m";
        if (const double seconds = cpuSecondsAt(convergence, dx); std::isfinite(seconds))
        {
            out << " and " << duration(seconds) << " of CPU";
        }
        if (dx < last.spacing)
        {
            const double finer = last.spacing / dx;
            out << ", extrapolated" << (finer > 1.05 ? ": " + number(finer, 2) + " times finer than any run" : "");
        }
        out << "\n";
    }
}

/// What the other axes do to the error at the finest spacing, by the runs that differ in one of them only.
void saySensitivities(std::ostream& out, const Study& study, const ErrorTable& table, const Row& finest)
{
    bool any = false;
    for (std::size_t k = 0; k < study.axes.size(); ++k)
    {
        for (const Row& other : table.rows)
        {
            if (study.axes[k].isSpacing || !other.hasError() ||
                !differOnlyIn(k, other.run->setting, finest.run->setting))
            {
                continue;
            }
            any = true;
            const double ratio = other.error / finest.error;
            out << "        with " << study.axes[k].name << " "
                << study.axes[k].values[other.run->setting.values[k]].label << " the error is " << number(ratio, 2)
                << " times that: "
                << (std::abs(ratio - 1) < 0.1 ? "it does not limit the error"
                    : ratio < 1               ? "it limits the error, at least in part"
                                              : "it increases the error")
                << "\n";
        }
    }
    if (!any)
    {
        out << "        cause unknown: no other axis was varied at this spacing\n";
    }
}

void sayWhereItStops(std::ostream& out, const Study& study, const ErrorTable& table, const Convergence& convergence)
{
    const Row& finest = *convergence.rows.back();
    if (!convergence.floor)
    {
        out << (finest.order > 0 ? "    the error decreases down to the finest run"
                                 : "    the error did not decrease at the last refinement")
            << "; order of the last pair " << number(finest.order, 2) << "\n";
        return;
    }
    const Row& stop = *convergence.rows[*convergence.floor];
    out << "    the error stops decreasing at dx = " << number(stop.spacing) << " m with "
        << errorText(*table.comparison, stop.error)
        << ": two refinements gain less than a tenth each; order of the last pair " << number(finest.order, 2)
        << "\n        the finest run, dx = " << number(finest.spacing) << " m, has "
        << errorText(*table.comparison, finest.error) << "\n";
    saySensitivities(out, study, table, finest);
}

void sayTitle(std::ostream& out, const std::string& scheme)
{
    out << "\n  " << (scheme == "-" ? "Over the spacing" : scheme) << "\n";
}

/// Whether anything was said.
bool sayScheme(std::ostream& out, const Study& study, const ErrorTable& table, const std::string& scheme)
{
    const Convergence convergence = convergenceOf(table, scheme);
    if (convergence.rows.size() < 2)
    {
        return false;
    }
    sayTitle(out, scheme);
    if (convergence.error)
    {
        sayNeeds(out, study, *table.comparison, convergence);
    }
    sayWhereItStops(out, study, table, convergence);
    return true;
}

/// The schemes of a family, one or, of an ensemble, the members; and what they say together.
void sayFamily(
    std::ostream& out, const Study& study, const ErrorTable& table, const std::string& family,
    const FigureUncertainty& figure
)
{
    bool isTitled = false;
    for (const auto& scheme : table.schemesOf(family))
    {
        isTitled = sayScheme(out, study, table, scheme) && scheme == family;
    }
    if (!figure.figures.empty())
    {
        if (!isTitled)
        {
            sayTitle(out, family);
        }
        out << uncertaintyTable(figure, study);
    }
}

/// The last words: each figure with its uncertainty.
void sayResults(
    std::ostream& out, const Study& study, const std::vector<ErrorTable>& tables,
    const std::vector<Uncertainties>& uncertainties
)
{
    out << "Figures of the finest spacings, with 95 % confidence:\n";
    for (std::size_t k = 0; k < tables.size(); ++k)
    {
        const auto families = tables[k].families();
        for (std::size_t n = 0; n < families.size(); ++n)
        {
            out << "    " << (families.size() > 1 ? families[n] + ": " : "") << tables[k].comparison->description << " "
                << uncertaintySentence(uncertainties[k][n], study) << "\n";
        }
    }
}

} // namespace

std::string summaryText(const Study& study, const std::vector<Run>& runs, const std::vector<ErrorTable>& tables)
{
    std::ostringstream out;
    std::vector<Uncertainties> uncertainties;
    for (const ErrorTable& table : tables)
    {
        const Comparison& comparison = *table.comparison;
        uncertainties.push_back(uncertaintiesOf(table, study));
        out << comparison.description << ": error against " << comparison.source << "\n";
        sayTargets(out, study, table, uncertainties.back());
        sayOutside(out, study, table);
        const auto families = table.families();
        for (std::size_t n = 0; n < families.size(); ++n)
        {
            sayFamily(out, study, table, families[n], uncertainties.back()[n]);
        }
        out << "\n";
    }
    for (const Run& run : runs)
    {
        if (!run.outcome.finished())
        {
            out << "Failed: " << run.setting.name << ": " << run.outcome.failure << "\n";
        }
    }
    sayResults(out, study, tables, uncertainties);
    return out.str();
}

} // namespace slosh
