// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseFacts.hpp"
#include "Result.hpp"

#include "study/Setting.hpp"

namespace slosh
{

/// An axis and what its values mean.
struct SweepAxis : Axis
{
    std::string unit;     ///< of its values, for tables and pictures; "" where none is said
    long naturalMode = 0; ///< n: the values are multiples of the n-th natural frequency of each case; 0: they are not
    bool isFrequency = false; ///< of the motion: natural frequencies are marked on it

    /// "frequency [omega/omega1]"
    std::string title() const;
};

/// One of the cases: what is set in it, and where it is.
struct SweptCase
{
    long number = 1; ///< in the order of the table, from 1
    Setting setting;
    DictionaryFiles files; ///< all its dictionaries
    CaseFacts facts;
    std::filesystem::path folder;
};

/// All entries of system/sweepDict.
Keys sweepDictKeys();

/// system/sweepDict: what is varied, which results are wanted. etc/annotated has every key.
struct Sweep
{
    std::vector<SweepAxis> axes;
    std::vector<std::size_t> memberAxes; ///< whose values make the members of an ensemble; none: there is no ensemble
    std::vector<Result> results;
    std::vector<SweptCase> cases;
    long slurmThreads = 1;                 ///< of each task
    std::vector<std::string> slurmOptions; ///< for sbatch: "--time=4:00:00"

    /// `files`: the dictionary files of the case; the cases get folders below `runs`. Throws CaseError.
    static Sweep read(const Dictionary& dict, const DictionaryFiles& files, const std::filesystem::path& runs);
};

} // namespace slosh
