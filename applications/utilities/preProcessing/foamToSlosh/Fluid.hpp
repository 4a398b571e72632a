// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// The liquid of the two phases.
struct Fluid
{
    double rho = 0; ///< [kg/m^3]
    double nu = 0;  ///< [m^2/s]

    /// The first phase, whose volume fraction is `field` ("alpha.water"; "alpha1" of foam-extend and of OpenFOAM before
    /// 2.3): of constant/transportProperties with `phases`, or with phase1 and phase2 (foam-extend, OpenFOAM before
    /// 2.3), or of constant/phaseProperties and physicalProperties.<phase> (OpenFOAM 10 and later). `warnings` says
    /// what is not used. Throws CaseError where the other phase is no gas.
    static Fluid read(const Case& from, const std::string& field, std::vector<std::string>& warnings);
};

} // namespace slosh
