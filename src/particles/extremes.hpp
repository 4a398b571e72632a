// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

namespace slosh
{

/// The largest of the liquid's particles; infinite where one is not a number.
struct Extremes
{
    double speed = 0;            ///< max |v|, [m/s]
    double densityDeviation = 0; ///< max |rho/rho0 - 1|
};

Extremes extremes(const Particles& particles, double rho0);

} // namespace slosh
