// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Comparison.hpp"
#include "OutsideRun.hpp"
#include "study/Setting.hpp"

namespace slosh
{

/// All entries of system/workPrecisionDict.
Keys workPrecisionDictKeys();

/// system/workPrecisionDict: what is varied, how errors are measured, which are wanted. etc/annotated has every key.
struct Study
{
    std::vector<Axis> axes;
    std::vector<Setting> settings; ///< coarsest spacing first: what is wrong shows early
    std::vector<Comparison> comparisons;
    std::vector<OutsideRun> outside; ///< runs of other programs, held against the same
    std::vector<double> targets;     ///< errors to be reached, largest first
    long threads = 1;
    double formalOrder = 2;                  ///< of the scheme: the highest order that is accepted
    std::string axesPlace, comparisonsPlace; ///< "system/workPrecisionDict:12", where they are

    /// `files`: the dictionary files of the case. Throws CaseError.
    static Study read(const Dictionary& dict, const DictionaryFiles& files);
};

} // namespace slosh
