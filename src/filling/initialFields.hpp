// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "particles/Particles.hpp"

namespace slosh
{

class Dictionary;

/// Sets velocity and pressure of the liquid at the start by formulas in the tank's coordinates x y z, [m], as #eval
/// takes them. What is left out stays as it is. Throws CaseError: a formula that is none, a value that is not finite, a
/// pressure below Tait's -B.
void setInitialFields(
    const Dictionary& initialFields, const Tank& tank, const TaitEquation& equationOfState, Particles& particles
);

/// initialFields { } of system/blockParticlesDict, and two of its entries.
Key initialFieldsKey();
Key initialVelocityKey();
Key initialPressureKey();

} // namespace slosh
