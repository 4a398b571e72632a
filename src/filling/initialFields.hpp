// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "particles/Particles.hpp"

namespace slosh
{

class Dictionary;

/// Sets velocity and pressure of the liquid at the start by formulas in the tank's coordinates x y z, [m], as #eval
/// takes them:
///     initialFields
///     {
///         A0  1;                           // any name: a constant of the formulas
///         U   ("-$A0*x" "0" "$A0*z");      // [m/s], in the tank's frame
///         p   "500*(1 - x^2 - z^2)";       // [Pa]; the density follows by Tait's equation
///     }
/// What is left out stays as it is. Throws CaseError: a formula that is none, a value that is not finite, a pressure
/// below Tait's -B.
void setInitialFields(
    const Dictionary& initialFields, const Tank& tank, const TaitEquation& equationOfState, Particles& particles
);

} // namespace slosh
