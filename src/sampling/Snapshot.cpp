// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/Snapshot.hpp"

#include <utility>

namespace slosh
{

Snapshot::Snapshot(const Scene& scene, const Particles& particles, TimeState state,
                   std::span<const BoundaryLayer> layers)
    : scene_(scene), particles_(particles), state_(std::move(state)), layers_(layers),
      bodyForce_(bodyForceIn(state_.frame, scene.gravity, state_.tank))
{
}

const CellGrid& Snapshot::fluidGrid() const
{
    if (!fluidGridBuilt_)
    {
        fluidGrid_.build(std::span<const Vec>(particles_.r).first(particles_.nFluid), scene_.kernel.supportRadius());
        fluidGridBuilt_ = true;
    }
    return fluidGrid_;
}

const CellGrid& Snapshot::wallGrid() const
{
    if (!wallGridBuilt_)
    {
        wallGrid_.build(std::span<const Vec>(particles_.r).subspan(particles_.nFluid), scene_.kernel.supportRadius());
        wallGridBuilt_ = true;
    }
    return wallGrid_;
}

Vec Snapshot::toSolver(const Vec& X) const
{
    return pointFromTank(X, state_.frame, state_.tank);
}

Vec Snapshot::toTank(const Vec& r) const
{
    return pointInTank(r, state_.frame, state_.tank);
}

} // namespace slosh
