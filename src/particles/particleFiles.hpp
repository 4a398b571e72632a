// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "case/Controls.hpp"
#include "motion/SolverFrame.hpp"
#include "motion/Wrench.hpp"
#include "particles/EnergyBudget.hpp"
#include "particles/Particles.hpp"

#include <optional>
#include <string>
#include <vector>

namespace slosh
{

/// All a time directory holds besides the clouds; <time>/uniform/time (value, index, deltaT, deltaT0 as OpenFOAM),
/// <time>/uniform/tankState (frame, mass, spacing, c, R, velocity, acceleration, omega, omegaDot; 17 digits) and, where
/// a run has them, <time>/uniform/stops, <time>/uniform/energyBudget (17 digits: a restart goes on with the same bits)
/// and <time>/uniform/sound; <time>/uniform/bricks where the liquid is in more than one (Particles::bricks): sums of a
/// time that is read have the order of those of the run.
struct TimeState
{
    double time = 0;   ///< [s]; that of the directory's name, where uniform/time says another
    long index = 0;    ///< steps since the case began
    double deltaT = 0; ///< last step, [s]
    Frame frame = Frame::tank;
    RigidState tank;
    std::optional<EnergyBudget> budget = std::nullopt;
    double begin = 0;               ///< when the case began: its first time directory, [s]
    std::vector<Wrench> stops = {}; ///< impulses of WallStops::onParts since then, [N s], [N m s]; empty: none
    std::optional<double> renamed = std::nullopt; ///< what uniform/time says, where that is another time, [s]
    std::vector<double> sound = {};               ///< of the grid of physics/AcousticDamper.hpp, where there is one

    SolverFrame solverFrame() const { return {frame, tank}; }
    /// Throws CaseError where `stops` are those of a tank with another number of parts.
    void requireStopsOn(std::size_t parts) const;
};

/// Writes <name>/: clouds `fluid` and `wall`, each the fields of its range (positions U p rho origId and those of
/// Particles::more), uniform/..., and, once per case, what ParaView and foamToVTK need beside them (<case>.foam;
/// constant/polyMesh is blockParticles' work). The directory appears under its name only when it is complete. Throws
/// CaseError (disk full, not writable) leaving none behind.
void writeTime(
    const Case& theCase, const std::string& name, const Particles& particles, const TimeState& state,
    const WriteOptions& options
);

/// Reads it back, with all scalarFields, vectorFields and labelFields of both clouds (the others go to Particles::more;
/// one of both clouds is there twice, by range); from a binary directory every value has its bits. Checks lengths, NaN
/// (file and particle), ids that occur twice, mass and spacing > 0.
Particles readTime(const Case& theCase, const std::string& name, TimeState& state);

} // namespace slosh
