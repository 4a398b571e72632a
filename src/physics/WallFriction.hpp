// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/FluidProperties.hpp"
#include "geometry/Tank.hpp"
#include "neighbours/CellGrid.hpp"
#include "particles/Particles.hpp"
#include "particles/particleFiles.hpp"
#include "physics/WallContact.hpp"

#include <cstdint>
#include <vector>

namespace slosh
{

/// Friction between liquid and walls that slip, from the liquid's viscosity nu alone, as accelerations of liquid
/// particles a:
/// - the shear stress of the boundary layers (particles/BoundaryLayer.hpp) on the layer next to the wall, the
///   particles nearer to it than a spacing dx, which is what a wall's face of dx^(dim-1) has before it:
///     dv_a/dt = -tau_w/(rho0 dx),   w the nearest site,
///   a site being a wall particle of the first row behind a face. Each has a boundary layer of its own, which the mean
///   velocity of the liquid around it drives while it is wet, and which ends when it dries;
/// - in 2D, of the two side walls of a slice of breadth B (FluidProperties::Friction), of which the particles know
///   nothing: dv_a/dt = -k (v_a - v_tank).
class WallFriction
{
public:
    /// `wallInTank`: wall particles in tank coordinates; `layers`: of each, where a run goes on, else none; `dragRate`:
    /// k, [1/s].
    WallFriction(const FluidProperties& fluid, const Tank& tank, double spacing, double dragRate,
                 const std::vector<Vec>& wallInTank, std::vector<BoundaryLayer> layers);

    /// Finds the particles that may come next to a wall while none moves farther than `margin`, [m], and their sites.
    void findNear(const Particles& particles, Frame frame, const RigidState& tank, double margin);

    /// Takes the layers over a step of `dt`, with what walls see of the liquid within it.
    void advance(const Particles& particles, const std::vector<WallContact>& contact, Frame frame,
                 const RigidState& tank, double dt);

    /// Adds to the accelerations of the liquid, in the solver's frame.
    void addTo(const Particles& particles, Frame frame, const RigidState& tank, std::vector<Vec>& acceleration) const;

    const std::vector<BoundaryLayer>& layers() const { return layers_; }

private:
    /// A liquid particle with the face that it is near to.
    struct Near
    {
        int particle, site;
        Vec normal;    ///< into the liquid, tank axes
        double offset; ///< distance to the face: normal . X - offset
    };

    const Tank& tank_;
    double nu_, rho0_, spacing_, dragRate_;
    std::vector<Vec> sites_;            ///< tank coordinates
    std::vector<int> wallOf_;           ///< of each site
    std::vector<Vec> normals_;          ///< of the face before it
    CellGrid grid_;                     ///< of the sites
    std::vector<BoundaryLayer> layers_; ///< by wall particle; those of sites alone are in use
    std::vector<Vec> stress_;           ///< tau by site, tank axes, [Pa]
    std::vector<std::uint8_t> cleared_; ///< by site: dry, and its layer is empty
    std::vector<Near> near_;
};

} // namespace slosh
