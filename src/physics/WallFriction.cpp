// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/WallFriction.hpp"

#include "base/parallel.hpp"

#include <limits>

namespace slosh
{

namespace
{

/// Of the sum of kernels at a wall particle of the first row a flat liquid has about a quarter: with less than this the
/// place is dry.
constexpr double wetShare = 0.1;

} // namespace

WallFriction::WallFriction(const FluidProperties& fluid, const Tank& tank, double spacing, double dragRate,
                           const std::vector<Vec>& wallInTank, std::vector<BoundaryLayer> layers)
    : tank_(tank), nu_(fluid.friction.nu), rho0_(fluid.rho0), spacing_(spacing), dragRate_(dragRate),
      layers_(std::move(layers))
{
    layers_.resize(wallInTank.size());
    for (std::size_t w = 0; w < wallInTank.size(); ++w)
    {
        const NearestSurface face = tank.nearestWall(wallInTank[w]);
        if (face.distance > -0.75 * spacing && face.distance < 0)
        {
            sites_.push_back(wallInTank[w]);
            wallOf_.push_back(static_cast<int>(w));
            normals_.push_back(face.normal);
            stress_.push_back(layers_[w].shearStress(rho0_, nu_));
        }
    }
    cleared_.resize(sites_.size());
    if (!sites_.empty())
    {
        grid_.build(sites_, 1.5 * spacing);
    }
}

void WallFriction::findNear(const Particles& particles, Frame frame, const RigidState& tank, double margin)
{
    near_.clear();
    const double reach = spacing_ + margin;
    const Vec low = tank_.box().min().array() + reach, high = tank_.box().max().array() - reach;
    const bool wallsAreTheBox = tank_.prism() == nullptr && tank_.bodies().empty();
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        const Vec X = pointInTank(particles.r[i], frame, tank);
        bool isFar = wallsAreTheBox;
        for (const int d : tank_.directions())
        {
            isFar = isFar && X[d] > low[d] && X[d] < high[d];
        }
        if (isFar)
        {
            continue;
        }
        const NearestSurface face = tank_.nearestWall(X);
        if (face.distance > reach)
        {
            continue;
        }
        int nearest = -1;
        double least = std::numeric_limits<double>::infinity();
        grid_.forEachNear(X, reach + spacing_,
                          [&](int site)
                          {
                              const double distance2 = (X - sites_[site]).squaredNorm();
                              if (distance2 < least)
                              {
                                  least = distance2;
                                  nearest = site;
                              }
                          });
        if (nearest >= 0)
        {
            near_.push_back({static_cast<int>(i), nearest, face.normal, face.normal.dot(X) - face.distance});
        }
    }
}

void WallFriction::advance(const Particles& particles, const std::vector<WallContact>& contact, Frame frame,
                           const RigidState& tank, double dt)
{
    const BoundaryLayer::Step step(dt);
    parallelFor(static_cast<std::ptrdiff_t>(sites_.size()),
                [&](std::ptrdiff_t site)
                {
                    const int w = wallOf_[site];
                    BoundaryLayer& layer = layers_[w];
                    if (contact[w].share < wetShare)
                    {
                        if (!cleared_[site])
                        {
                            layer = BoundaryLayer();
                            stress_[site].setZero();
                            cleared_[site] = true;
                        }
                        return;
                    }
                    cleared_[site] = false;
                    // The tank's velocity where the liquid is seen, which is not quite that of the wall where the tank
                    // turns.
                    Vec carried = particles.v[particles.nFluid + w];
                    if (frame == Frame::inertial)
                    {
                        carried += tank.omega.cross(contact[w].away);
                    }
                    const Vec u = alongTankAxes(contact[w].velocity - carried, frame, tank);
                    layer.advance(u - u.dot(normals_[site]) * normals_[site], step);
                    stress_[site] = layer.shearStress(rho0_, nu_);
                });
}

void WallFriction::addTo(const Particles& particles, Frame frame, const RigidState& tank,
                         std::vector<Vec>& acceleration) const
{
    const double perStress = 1 / (rho0_ * spacing_);
    parallelFor(static_cast<std::ptrdiff_t>(near_.size()),
                [&](std::ptrdiff_t k)
                {
                    const Near& near = near_[k];
                    const int i = near.particle;
                    const Vec X = pointInTank(particles.r[i], frame, tank);
                    if (near.normal.dot(X) - near.offset < spacing_)
                    {
                        const Vec& tau = stress_[near.site];
                        acceleration[i] -= perStress * fromTankAxes(tau, frame, tank);
                    }
                });
    if (dragRate_ == 0)
    {
        return;
    }
    if (frame == Frame::tank)
    {
        parallelFor(particles.nFluid, [&](std::ptrdiff_t i) { acceleration[i] -= dragRate_ * particles.v[i]; });
        return;
    }
    parallelFor(particles.nFluid,
                [&](std::ptrdiff_t i)
                {
                    const Vec carried = tank.velocityAt(tank.pointToTank(particles.r[i]));
                    acceleration[i] -= dragRate_ * (particles.v[i] - carried);
                });
}

} // namespace slosh
