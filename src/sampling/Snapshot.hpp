// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particleFiles.hpp"
#include "physics/BodyForce.hpp"
#include "sampling/forNeighbours.hpp"
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

    /// forNeighbours() of the liquid around r: f(index into particles(), r - r_b).
    template <class F>
    void forLiquidNear(const Vec& r, const F& f) const
    {
        forNeighbours(fluidGrid(), liquid(), scene_.kernel, r, f);
    }
    /// The same of the walls, numbered from 0 at the first.
    template <class F>
    void forWallsNear(const Vec& r, const F& f) const
    {
        forNeighbours(wallGrid(), walls(), scene_.kernel, r, f);
    }
    /// To be built before threads ask for it.
    const CellGrid& fluidGrid() const;

private:
    std::span<const Vec> liquid() const { return std::span(particles_.r).first(particles_.nFluid); }
    std::span<const Vec> walls() const { return std::span(particles_.r).subspan(particles_.nFluid); }
    const CellGrid& wallGrid() const;

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
