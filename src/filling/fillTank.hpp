// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "particles/Particles.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// How a tank was filled.
struct Filling
{
    Particles particles; ///< in tank coordinates, at rest, hydrostatic
    Vec spacing;         ///< of the lattice in each direction (empty: its extent), [m]
    /// What was adjusted so that whole cells fit, and by how much; one line each, none where nothing was.
    std::vector<std::string> adjustments;
};

/// Fills the tank with particles at the centres of lattice cells of about `dx` and surrounds the liquid with
/// `wallLayers` of wall particles on the same lattice: latticeSites(), or sectionSites() where the walls are a section
/// drawn out. In each direction the spacing is L/n
/// with n = round(L/dx), vertically D/n with the depth D; all particles have the mass m = rho0 V/N of the liquid's
/// volume V, so that the total mass is rho0 V to rounding; V is exact where volumeOfBoth() is. Bodies become wall
/// particles where a cell's centre lies inside; `wallLayers` 0: free space, no walls around. p: the Tait column under
/// |g|, zero at the surface of each region of liquid; rho from it. `reachOverDx`: the kernel's support; bodies and
/// walls thinner than that are refused. Throws CaseError: dx larger than the tank or the depth, a thin body or wall,
/// too many particles.
Filling fillTank(
    const Tank& tank, double dx, int wallLayers, double rho0, const TaitEquation& equationOfState, double gravity,
    double reachOverDx
);

} // namespace slosh
