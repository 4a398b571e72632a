// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <cstddef>
#include <vector>

namespace slosh
{

/// The state of all particles, in double precision, always three components: [fluid | wall].
///
/// All particles have the same mass m: that is what lattice filling gives, and it keeps a pair record at eight values.
/// A wall (dummy) particle carries the same mass, so that walls and liquid have the same number density.
struct Particles
{
    std::ptrdiff_t nFluid = 0;
    std::ptrdiff_t nWall = 0;

    std::vector<Vec> r;      ///< positions in the solver's frame, [m]
    std::vector<Vec> v;      ///< velocities in the solver's frame, [m/s]
    std::vector<double> rho; ///< density, [kg/m^3]
    std::vector<double> p;   ///< pressure, [Pa]
    std::vector<int> id;     ///< origId: unique within fluid and within wall, kept for life

    /// <D>, the mean of the density diffusion over the last thousand steps or so, of the liquid, [kg/m^3/s]
    /// (physics/FourtakasDensityDiffusion.hpp); empty: 0.
    std::vector<double> meanDiffusion;

    double mass = 0;    ///< m of one particle; in 2D per metre of thickness: [kg] or [kg/m]
    double spacing = 0; ///< particleSpacing dx = (m/rho0)^(1/dim), [m]

    std::ptrdiff_t size() const { return nFluid + nWall; }
    void resize(std::ptrdiff_t fluid, std::ptrdiff_t wall);
};

} // namespace slosh
