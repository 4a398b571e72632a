// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"
#include "physics/Rates.hpp"

namespace slosh
{

/// Takes <D> of physics/FourtakasDensityDiffusion.hpp, where the particles have it, over a step of `dt`:
///   <D> <- <D> + (1 - e^(-dt/T)) (D - <D>),   T = 1000 h/c0; while the case is younger the time since its start, at
///   least T/10.
void advanceMeanDiffusion(
    Particles& particles, const Rates& rates, double smoothingLength, double c0, double sinceStart, double dt
);

} // namespace slosh
