// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseFacts.hpp"

#include "dictionary/Dictionary.hpp"

#include <string>

namespace slosh
{

/// One figure that each case gives, an entry as compareSamples knows it. Left out may be `reference` (there is none)
/// and the `period` of meanPeak (that of the tank's motion); `lastPeriods 5;` instead of timeStart: the last five of
/// those.
struct Result
{
    std::string name, description;
    std::string unit;            ///< "" where none is said
    bool hasUncertainty = false; ///< the figure is a mean of peaks, which has one
    bool hasReference = false;   ///< what the figure is held against: a column and a curve of its own
    bool needsPeriod = false;    ///< the motion must be harmonic
    double lastPeriods = 0;      ///< 0: it is timeStart that counts
    std::string reference;       ///< what it is, in words
    std::string entries;         ///< the dictionary as text
    bool lacksPeriod = false;    ///< of meanPeak

    /// The entry for compareSamples in a case. Throws CaseError where it needs a period and the motion has none, or the
    /// run is shorter than the periods.
    std::string text(const CaseFacts& facts) const;
    std::string title() const { return unit.empty() ? name : name + " [" + unit + "]"; }
};

/// An entry of the dictionary `results`.
Key resultKey();

/// Throws CaseError for a wrong quantity and for what compareSamples would not read; the samples themselves show when
/// the first case has ended.
Result readResult(const Dictionary& dict, const std::string& name);

/// "1.5 m" of a value in its unit.
std::string withUnit(const std::string& value, const std::string& unit);

} // namespace slosh
