// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/FluidProperties.hpp"
#include "fluid/TaitEquation.hpp"
#include "geometry/Tank.hpp"
#include "kernels/Kernel.hpp"
#include "motion/BodyForce.hpp"
#include "neighbours/CellGrid.hpp"
#include "particles/particleFiles.hpp"

#include <span>

namespace slosh
{

/// What never changes during a run and samples need.
struct Scene
{
    const Tank& tank;
    const Kernel& kernel;
    Vec gravity;
    TaitEquation equationOfState;
    bool wallSuction = false; ///< system/sphSchemes wall { suction }
    FluidProperties fluid{};
    double particleSpacing = 0; ///< [m]
};

/// The liquid at one instant, as run-time functions and probeSample see it: the same samples either way. Refers to what
/// it was made of. Grids are built when first asked for.
class Snapshot
{
public:
    /// `layers`: the walls' boundary layers, where there is friction (TimeState::layers); not copied.
    Snapshot(const Scene& scene, const Particles& particles, TimeState state,
             std::span<const BoundaryLayer> layers = {});

    const Scene& scene() const { return scene_; }
    const Particles& particles() const { return particles_; }
    const TimeState& state() const { return state_; }
    std::span<const BoundaryLayer> layers() const { return layers_; }
    const BodyForce& bodyForce() const { return bodyForce_; }
    const CellGrid& fluidGrid() const; ///< indices into particles
    const CellGrid& wallGrid() const;  ///< indices from 0 at the first wall particle

    /// A point of the tank, in the solver's coordinates, and back.
    Vec toSolver(const Vec& X) const;
    Vec toTank(const Vec& r) const;

private:
    const Scene& scene_;
    const Particles& particles_;
    TimeState state_;
    std::span<const BoundaryLayer> layers_;
    BodyForce bodyForce_;
    mutable CellGrid fluidGrid_;
    mutable CellGrid wallGrid_;
    mutable bool fluidGridBuilt_ = false;
    mutable bool wallGridBuilt_ = false;
};

} // namespace slosh
