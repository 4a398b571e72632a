// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/Walls.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <utility>

namespace slosh
{

Walls::Walls(
    const Scene& scene, const Particles& particles, std::vector<Vec> inTank, const SolverFrame& frame, bool seesLiquid
)
    : inTank_(std::move(inTank)), frame_(frame)
{
    if (scene.fluid.friction.boundaryLayers)
    {
        friction_.emplace(
            scene.fluid, scene.tank, scene.fluid.sideWallDrag(scene.tank, scene.gravity), inTank_, particles
        );
    }
    contact_.resize(friction_ || seesLiquid ? inTank_.size() : 0);
}

bool Walls::move(const SolverFrame& frame, Particles& particles)
{
    frame_ = frame;
    if (frame.wallsRest())
    {
        return false;
    }
    parallelFor(
        particles.nWall,
        [&](std::ptrdiff_t w)
        {
            particles.r[particles.nFluid + w] = frame.fromTank(inTank_[w]);
            particles.v[particles.nFluid + w] = frame.wallVelocity(inTank_[w]);
        }
    );
    return true;
}

void Walls::listBuilt(Particles& particles, double rho0, double margin)
{
    std::fill(particles.p.begin() + particles.nFluid, particles.p.end(), 0.0);
    std::fill(particles.rho.begin() + particles.nFluid, particles.rho.end(), rho0);
    for (WallContact& contact : contact_)
    {
        contact = {0, Vec::Zero(), Vec::Zero(), contact.enclosed};
    }
    margin_ = margin;
    nearIsOld_ = true;
}

void Walls::addFriction(const Particles& particles, const SolverFrame& frame, std::vector<Vec>& acceleration)
{
    if (!friction_)
    {
        return;
    }
    if (nearIsOld_)
    {
        friction_->findNear(particles, frame, margin_);
        nearIsOld_ = false;
    }
    friction_->addTo(particles, frame, acceleration);
}

void Walls::advance(Particles& particles, double dt)
{
    if (friction_)
    {
        friction_->advance(particles, contact_, frame_, dt);
    }
}

} // namespace slosh
