// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "dictionary/Dictionary.hpp"
#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <optional>

namespace slosh
{

/// constant/fluidProperties.
struct FluidProperties
{
    double rho0 = 1000;
    double gamma = 7;
    std::optional<double> speedOfSound; ///< none: automaticSpeedOfSound()
    bool slip = false;                  ///< walls take no shear: viscosity acts within the liquid alone

    /// Friction at walls that slip, physics/WallFriction.hpp.
    struct Friction
    {
        bool boundaryLayers = false;
        double nu = 0;               ///< kinematic viscosity of the liquid, [m^2/s]
        double breadth = 0;          ///< B of a slice between side walls, [m]; 0: none
        std::optional<double> omega; ///< of the motion that they damp, [rad/s]; none: the first natural one
    } friction;

    /// Rate k at which the side walls of a 2D slice take from the velocity, a = -k u, [1/s]: laminar Stokes layers of
    /// an oscillation on both,
    ///   k = 2 sqrt(nu omega/2)/B.
    /// Only the kinetic half of a wave's energy is damped: its energy falls at k, its amplitude at k/2. 0 without them.
    /// Throws CaseError where omega is to be the tank's and it has none.
    double sideWallDrag(const Tank& tank, const Vec& gravity) const;

    /// All but the viscosity itself, viscosities/readViscosity.hpp, and its keys.
    static FluidProperties read(const Dictionary& fluidProperties);
    /// With the speed of sound given, or `automatic`. The artificially compressible column of depth
    /// D shall weigh what the real one weighs and be as high: its density at the surface is the rho0 of the equation of
    /// state, less than this rho0 by about g D/(2 c0^2), and its mean is this rho0. Of a tank that is no box it is the
    /// mean over the liquid's volume, whose breadth changes with the depth.
    TaitEquation equationOfState(const Tank& tank, const Vec& gravity, double automatic) const;
};

/// All entries of constant/fluidProperties: that of the viscosity is declared with the viscosities, but for its
/// `walls`.
Keys fluidPropertiesKeysBeside(const Key& viscosity);
Key viscosityWallsKey();

/// c0 = 10 v_max, so that the density varies by about 1 % (Monaghan 1994; Cao et al. 2014). v_max = sqrt(g D), the
/// speed of the fastest shallow-water wave, plus the greatest speed that the tank's corners can have relative to the
/// liquid in the first 100 s of the motion (SolidBodyMotion::greatestSpeed), [m/s].
double automaticSpeedOfSound(
    const Tank& tank, const Vec& gravity, const SolidBodyMotion& motion, bool liquidRestsInTank = false
);

} // namespace slosh
