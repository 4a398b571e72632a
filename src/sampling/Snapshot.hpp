// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neighbours/CellGrid.hpp"
#include "particles/particleFiles.hpp"
#include "physics/BodyForce.hpp"
#include "scene/Scene.hpp"

namespace slosh
{

/// The liquid at one instant, as run-time functions and probeSample see it: the same samples either way. Refers to what
/// it was made of. Grids are built when first asked for.
class Snapshot
{
public:
    Snapshot(const Scene& scene, const Particles& particles, TimeState state);

    const Scene& scene() const { return scene_; }
    const Particles& particles() const { return particles_; }
    const TimeState& state() const { return state_; }
    const SolverFrame& frame() const { return frame_; }
    const BodyForce& bodyForce() const { return bodyForce_; }
    const CellGrid& fluidGrid() const; ///< indices into particles
    const CellGrid& wallGrid() const;  ///< indices from 0 at the first wall particle

private:
    const Scene& scene_;
    const Particles& particles_;
    TimeState state_;
    SolverFrame frame_;
    BodyForce bodyForce_;
    mutable CellGrid fluidGrid_;
    mutable CellGrid wallGrid_;
    mutable bool fluidGridBuilt_ = false;
    mutable bool wallGridBuilt_ = false;
};

} // namespace slosh
