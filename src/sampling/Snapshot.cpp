// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/Snapshot.hpp"

#include "physics/bodyForceIn.hpp"

#include <utility>

namespace slosh
{

Snapshot::Snapshot(const Scene& scene, const Particles& particles, TimeState state)
    : scene_(scene), particles_(particles), state_(std::move(state)), frame_(state_.solverFrame()),
      bodyForce_(bodyForceIn(frame_, scene.gravity))
{
}

const CellGrid& Snapshot::fluidGrid() const
{
    if (!fluidGridBuilt_)
    {
        fluidGrid_.build(liquid(), scene_.kernel.supportRadius());
        fluidGridBuilt_ = true;
    }
    return fluidGrid_;
}

const CellGrid& Snapshot::wallGrid() const
{
    if (!wallGridBuilt_)
    {
        wallGrid_.build(walls(), scene_.kernel.supportRadius());
        wallGridBuilt_ = true;
    }
    return wallGrid_;
}

} // namespace slosh
