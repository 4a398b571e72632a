// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Choice.hpp"
#include "motion/SolverFrame.hpp"
#include "physics/makeInteractions.hpp"

#include <string>

namespace slosh
{

/// system/sphSchemes: how the equations are solved. What it says nothing of comes from its scheme
/// (case/namedSchemes.hpp), whose entries stand in the dictionary that is read here.
struct Schemes
{
    Frame frame = Frame::tank;
    std::string timeIntegration = "predictorCorrector"; ///< one of TimeIntegrator::names()
    double densityDiffusion = 0;                        ///< delta, see physics/DensityDiffusion.hpp; 0: none
    long densityInterval = 20; ///< steps between two re-initialisations of the density; 0: never
    double soundDamping = 0;   ///< coefficient, see physics/AcousticDamper.hpp; 0: none
    double dampingLength = 0;  ///< of its grid, [m]; 0: AcousticDamper::length
    Precision precision = Precision::single;
    // Bounds that a sound run keeps; beyond them it stops.
    double maxDensityDeviation = 0.3; ///< max |rho/rho0 - 1|
    long maxParticlesOutside = 0;
    double maxCourantNumber = 0.944; ///< c0 dt/h; default TimeIntegrator::unstableCo()

    /// Throws CaseError for unknown keys, words and values out of range.
    static Schemes read(const Dictionary& sphSchemes);
    /// The density diffusions by their names; each reads delta from densityDiffusion { }.
    static const std::vector<Choice<double (*)(const Dictionary& entries)>>& densityDiffusions();
};

/// All entries of system/sphSchemes.
Keys sphSchemesKeys();

} // namespace slosh
