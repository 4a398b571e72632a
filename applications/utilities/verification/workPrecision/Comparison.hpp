// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <string>

namespace slosh
{

/// An entry of the dictionary `comparisons`.
Key comparisonKey();

/// One of the quantities that errors are given of: an entry as compareSamples knows it, whose reference may also be
/// made of the study's own runs.
struct Comparison
{
    enum class Reference
    {
        independent, ///< compareSamples has it: exact, measured, stated, another case
        finest,
        run,
        richardson
    };

    std::string name, description;
    Reference reference = Reference::independent;
    std::string run;      ///< of Reference::run
    bool isShare = true;  ///< errors are shares of the reference; else in the unit of the figure
    bool isSeries = true; ///< quantity difference: the error is that of a whole series, there is no figure
    std::string unit;     ///< of the figure, "" where none is given
    std::string source;   ///< what stands behind the reference, for the summary
    std::string entries;  ///< the dictionary as text

    /// The entry for compareSamples; `referenceRun`: the case directory of the run that is the reference, relative to
    /// the one that is compared, where the reference is one.
    std::string text(const std::string& referenceRun) const;
    bool needsRun() const { return reference == Reference::finest || reference == Reference::run; }
};

/// Throws CaseError for what is wrong in a reference of these three types; compareSamples looks after the rest.
Comparison readComparison(const Dictionary& dict, const std::string& name);

/// An error in words: "4.2 %", or with its unit where it is no share.
std::string errorText(const Comparison& comparison, double error);

} // namespace slosh
