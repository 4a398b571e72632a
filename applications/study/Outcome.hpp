// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace slosh
{

/// What came of a run: kept in the file `cost` of its folder, whose presence says that it has ended.
struct Outcome
{
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string failure; ///< why it failed; "" for one that came to its end
    long threads = 1;
    double cpuSeconds = 0;    ///< of blockParticles, which settles the liquid, and the solver
    double wallSeconds = 0;   ///< the same
    double peakMemory = 0;    ///< of the solver, [MB]
    double spacing = unknown; ///< as blockParticles adjusted it, [m]
    long particles = 0;       ///< liquid
    long steps = 0;
    long evaluations = 0; ///< of the right-hand sides

    bool finished() const { return failure.empty(); }
};

/// Takes spacing, particles, steps and evaluations from what sloshSPHFoam has printed, as far as it came.
void readSolverLog(const std::filesystem::path& log, Outcome& outcome);

/// The outcome kept in a run's folder; nothing where it has not ended. Throws CaseError.
std::optional<Outcome> readOutcome(const std::filesystem::path& folder, const std::string& file = "cost");
void writeOutcome(const std::filesystem::path& folder, const Outcome& outcome, const std::string& file = "cost");

} // namespace slosh
