// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "geometry/Tank.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "particles/TaitEquation.hpp"

#include <optional>

namespace slosh
{

class Dictionary;

/// constant/fluidProperties:
///     rho0             1000;                                       // [kg/m^3]
///     equationOfState  { type Tait; gamma 7; speedOfSound auto; }  // auto | [m/s]
///     viscosity        { type artificial; alpha 0.03; }            // or { type laminar; nu 1e-6; walls noSlip; }, nu
///     in
///                                     // [m^2/s], walls noSlip | slip; { type lowDissipationRiemann; }, { type none; }
struct FluidProperties
{
    enum class Viscosity
    {
        none,
        artificial,
        laminar,
        lowDissipationRiemann
    };

    double rho0 = 1000;
    double gamma = 7;
    std::optional<double> speedOfSound; ///< none: automaticSpeedOfSound()
    Viscosity viscosity = Viscosity::artificial;
    double alpha = 0.03; ///< artificial
    double nu = 0;       ///< laminar, [m^2/s]
    bool slip = false;   ///< laminar: walls take no shear

    static FluidProperties read(const Dictionary& fluidProperties);

    /// With the speed of sound given, or chosen for this tank and motion. The artificially compressible column of depth
    /// D shall weigh what the real one weighs and be as high: its density at the surface is the rho0 of the equation of
    /// state, less than this rho0 by about g D/(2 c0^2), and its mean is this rho0. Of a prism it is the mean over the
    /// liquid's volume, whose breadth changes with the depth.
    TaitEquation equationOfState(const Tank& tank, const Vec& gravity, const SolidBodyMotion& motion) const;
};

/// c0 = 10 v_max, so that the density varies by about 1 % (Monaghan 1994; Cao et al. 2014). v_max = sqrt(g D), the
/// speed of the fastest shallow-water wave, plus the greatest speed of the tank's corners in the first 100 s of the
/// motion, [m/s].
double automaticSpeedOfSound(const Tank& tank, const Vec& gravity, const SolidBodyMotion& motion);

} // namespace slosh
