// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ensemble.hpp"

#include "base/counted.hpp"
#include "base/numberText.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

/// The axes that are not of members.
std::vector<std::size_t> otherAxes(const Sweep& sweep)
{
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < sweep.axes.size(); ++k)
    {
        if (std::find(sweep.memberAxes.begin(), sweep.memberAxes.end(), k) == sweep.memberAxes.end())
        {
            others.push_back(k);
        }
    }
    return others;
}

std::vector<std::string> labelsOf(const SweptCase& one, const Sweep& sweep)
{
    std::vector<std::string> labels;
    for (const std::size_t k : otherAxes(sweep))
    {
        labels.push_back(sweep.axes[k].values[one.setting.values[k]].label);
    }
    return labels;
}

/// What is known of the figures.
std::vector<double> known(const std::vector<CaseState::Figure>& figures, double CaseState::Figure::*value)
{
    std::vector<double> values;
    for (const auto& figure : figures)
    {
        if (!std::isnan(figure.*value))
        {
            values.push_back(figure.*value);
        }
    }
    return values;
}

Ensemble ensembleOf(const std::vector<CaseState::Figure>& figures)
{
    Ensemble ensemble;
    ensemble.ours = summarise(known(figures, &CaseState::Figure::value));
    ensemble.missing = figures.size() - ensemble.ours.count;
    ensemble.reference = summarise(known(figures, &CaseState::Figure::reference)).mean;
    ensemble.referenceUncertainty = summarise(known(figures, &CaseState::Figure::referenceUncertainty)).mean;
    return ensemble;
}

std::string number(double value, int digits = 6)
{
    return std::isnan(value) ? "nan" : numberText(value, digits);
}

std::string within(const Ensemble& ensemble)
{
    return std::isnan(ensemble.combinedUncertainty())                          ? "nan"
           : std::abs(ensemble.difference()) <= ensemble.combinedUncertainty() ? "yes"
                                                                               : "no";
}

std::string withDeviation(double value, double deviation)
{
    return number(value, 5) + (std::isnan(deviation) ? "" : " +- " + number(deviation, 3));
}

} // namespace

double Ensemble::combinedUncertainty() const
{
    return std::hypot(ours.standardError, referenceUncertainty);
}

std::vector<Ensemble> ensemblesOf(const Sweep& sweep, const std::vector<CaseState>& states)
{
    std::vector<std::vector<std::string>> groups; // in the order in which they come
    for (const SweptCase& one : sweep.cases)
    {
        if (const auto labels = labelsOf(one, sweep); std::find(groups.begin(), groups.end(), labels) == groups.end())
        {
            groups.push_back(labels);
        }
    }
    std::vector<Ensemble> ensembles;
    for (const auto& labels : groups)
    {
        for (std::size_t k = 0; k < sweep.results.size(); ++k)
        {
            std::vector<CaseState::Figure> figures;
            for (std::size_t i = 0; i < states.size(); ++i)
            {
                if (labelsOf(sweep.cases[i], sweep) == labels)
                {
                    figures.push_back(states[i].figures[k]);
                }
            }
            ensembles.push_back(ensembleOf(figures));
            ensembles.back().values = labels;
            ensembles.back().result = k;
        }
    }
    return ensembles;
}

std::string ensembleTable(const Sweep& sweep, const std::vector<Ensemble>& ensembles)
{
    std::string text = "# ";
    for (const std::size_t k : otherAxes(sweep))
    {
        text += sweep.axes[k].title() + "\t";
    }
    text += "result\tunit\tmembers\tmissing\tmean\tstandard deviation\tstandard error\treference\t"
            "reference uncertainty\tdifference\tcombined uncertainty\twithin\tsource\n";
    for (const Ensemble& ensemble : ensembles)
    {
        const Result& result = sweep.results[ensemble.result];
        for (const auto& value : ensemble.values)
        {
            text += value + "\t";
        }
        text += result.name + "\t" + (result.unit.empty() ? "-" : result.unit) + "\t" +
                std::to_string(ensemble.ours.count) + "\t" + std::to_string(ensemble.missing);
        for (const double value :
             {ensemble.ours.mean, ensemble.ours.standardDeviation, ensemble.ours.standardError, ensemble.reference,
              ensemble.referenceUncertainty, ensemble.difference(), ensemble.combinedUncertainty()})
        {
            text += "\t" + number(value);
        }
        text += "\t" + within(ensemble) + "\t" + (result.hasReference ? result.reference : "-") + "\n";
    }
    return text;
}

std::string ensembleText(const Sweep& sweep, const std::vector<Ensemble>& ensembles)
{
    std::string text;
    for (const Ensemble& ensemble : ensembles)
    {
        const Result& result = sweep.results[ensemble.result];
        const auto others = otherAxes(sweep);
        for (std::size_t k = 0; k < others.size(); ++k)
        {
            text += sweep.axes[others[k]].name + "=" + ensemble.values[k] + ", ";
        }
        text += result.description + ": " +
                withUnit(withDeviation(ensemble.ours.mean, ensemble.ours.standardDeviation), result.unit) + " of " +
                counted(ensemble.ours.count, "member") +
                (ensemble.missing > 0 ? " (" + std::to_string(ensemble.missing) + " missing)" : "");
        if (!std::isnan(ensemble.reference))
        {
            text += "; reference " +
                    withUnit(withDeviation(ensemble.reference, ensemble.referenceUncertainty), result.unit) + " (" +
                    result.reference + "); difference " + number(ensemble.difference(), 3);
        }
        if (!std::isnan(ensemble.combinedUncertainty()))
        {
            text += ", combined uncertainty " + number(ensemble.combinedUncertainty(), 3) + " (standard error " +
                    number(ensemble.ours.standardError, 3) + ", reference's " +
                    number(ensemble.referenceUncertainty, 3) +
                    "): " + (within(ensemble) == "yes" ? "within" : "outside");
        }
        text += "\n";
    }
    return text;
}

std::string sameMembers(const Sweep& sweep, const std::vector<CaseState>& states)
{
    const auto isSame = [&](std::size_t i, std::size_t j)
    {
        return labelsOf(sweep.cases[i], sweep) == labelsOf(sweep.cases[j], sweep) &&
               std::equal(
                   states[i].figures.begin(), states[i].figures.end(), states[j].figures.begin(),
                   [](const auto& a, const auto& b) { return a.value == b.value; }
               ); // nan is like nothing
    };
    std::string text;
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            if (isSame(i, j))
            {
                text += "--> FOAM Warning: " + sweep.cases[i].setting.name + " and " + sweep.cases[j].setting.name +
                        " have the same results to the last digit: do these members differ?\n";
                break;
            }
        }
    }
    return text;
}

} // namespace slosh
