// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Comparison.hpp"
#include "study/Outcome.hpp"
#include "study/Setting.hpp"

namespace slosh
{

/// The programs a study starts.
struct Programs
{
    std::filesystem::path blockParticles, sloshSPHFoam, compareSamples;

    /// Throws CaseError where one is missing.
    static Programs find();
};

/// What compareSamples found of a comparison; NaN: nothing.
struct Compared
{
    double figure = Outcome::unknown;
    double error = Outcome::unknown;         ///< absolute
    double standardError = Outcome::unknown; ///< of the figure, where it is a mean over periods
    std::size_t count = 0;                   ///< of these; 0: it is no such mean
};

/// One run: a case of its own in `folder`.
struct Run
{
    Setting setting;
    std::filesystem::path folder;
    Outcome outcome;
    std::vector<Compared> compared; ///< by comparison
};

/// Whether the folder holds the outcome of just these dictionaries on as many threads; if so it is taken.
bool takeEarlierOutcome(Run& run, const DictionaryFiles& files, long threads);

/// Makes the case anew and runs it: blockParticles, sloshSPHFoam. A program that fails is an outcome, no exception.
void perform(Run& run, const DictionaryFiles& files, long threads, const Programs& programs);

/// Runs compareSamples in the case of a finished run, unless it has compared just this since that run and `reference`,
/// whose samples it takes, have ended; reads what it found. Throws CaseError with its message where it does not like
/// the comparisons; where it cannot compare this run, that becomes its failure.
void compare(
    Run& run, const std::vector<Comparison>& comparisons, const std::vector<const Run*>& references,
    const Programs& programs
);

} // namespace slosh
