// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/FluidProperties.hpp"
#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"
#include "neighbours/CellGrid.hpp"
#include "particles/Particles.hpp"
#include "physics/WallContact.hpp"

#include <cstdint>
#include <vector>

namespace slosh
{

/// Friction between liquid and walls that slip, from the liquid's viscosity nu alone, as accelerations of liquid
/// particles a:
/// - the shear stress of the boundary layers (physics/BoundaryLayer.hpp) on the layer next to the wall, the
///   particles nearer to it than a spacing dx, which is what a wall's face of dx^(dim-1) has before it:
///     dv_a/dt = -tau_w/(rho0 dx),   w the nearest site,
///   a site being a wall particle of the first row behind a face. Each has a boundary layer of its own, which the mean
///   velocity of the liquid around it drives while it is wet, and which ends when it dries;
/// - in 2D, of the two side walls of a slice of breadth B (FluidProperties::Friction), of which the particles know
///   nothing: dv_a/dt = -k (v_a - v_tank).
class WallFriction
{
public:
    /// The boundary layers by wall particle, the state that goes from step to step: layerU, layerWay, layerMemory0 ...,
    /// the members of BoundaryLayer.
    static std::vector<Field> layerFields();
    /// Throws CaseError where `particles` have some of them and lack others.
    static void requireAllOrNoLayerFields(const Particles& particles);

    /// `wallInTank`: wall particles in tank coordinates; `particles`: their layers, which are empty where it has no
    /// such fields; `dragRate`: k, [1/s]. Throws as requireAllOrNoLayerFields().
    WallFriction(
        const FluidProperties& fluid, const Tank& tank, double dragRate, const std::vector<Vec>& wallInTank,
        const Particles& particles
    );

    /// Finds the particles that may come next to a wall while none moves farther than `margin`, [m], and their sites.
    void findNear(const Particles& particles, const SolverFrame& frame, double margin);

    /// Takes the layers over a step of `dt`, with what walls see of the liquid within it.
    void advance(Particles& particles, const std::vector<WallContact>& contact, const SolverFrame& frame, double dt);

    /// Adds to the accelerations of the liquid, in the solver's frame.
    void addTo(const Particles& particles, const SolverFrame& frame, std::vector<Vec>& acceleration) const;

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
    std::vector<int> wallOf_;           ///< of each site, from 0 at the first wall particle
    std::vector<Vec> normals_;          ///< of the face before it
    CellGrid grid_;                     ///< of the sites
    std::vector<Vec> stress_;           ///< tau by site, tank axes, [Pa]
    std::vector<std::uint8_t> cleared_; ///< by site: dry, and its layer is empty
    std::vector<Near> near_;
};

} // namespace slosh
