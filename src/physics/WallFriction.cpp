// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/WallFriction.hpp"

#include "base/CaseError.hpp"
#include "base/parallel.hpp"
#include "physics/BoundaryLayer.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>

namespace slosh
{

namespace
{

/// Of the sum of kernels at a wall particle of the first row a flat liquid has about a quarter: with less than this the
/// place is dry.
constexpr double wetShare = 0.1;

/// A wall's boundary layer where it stands in the fields of the particles.
template <class V>
class LayerFields
{
public:
    template <class P>
    explicit LayerFields(P& particles)
        : u_(particles.template values<Vec>("layerU")), way_(particles.template values<Vec>("layerWay"))
    {
        for (std::size_t k = 0; k < BoundaryLayer::modes; ++k)
        {
            z_[k] = particles.template values<Vec>("layerMemory" + std::to_string(k));
        }
    }
    BoundaryLayer at(int w) const
    {
        BoundaryLayer layer;
        if (!u_.empty())
        {
            layer.u = u_[w];
            layer.way = way_[w];
            for (std::size_t k = 0; k < BoundaryLayer::modes; ++k)
            {
                layer.z[k] = z_[k][w];
            }
        }
        return layer;
    }
    void put(int w, const BoundaryLayer& layer) const
    {
        u_[w] = layer.u;
        way_[w] = layer.way;
        for (std::size_t k = 0; k < BoundaryLayer::modes; ++k)
        {
            z_[k][w] = layer.z[k];
        }
    }

private:
    std::span<V> u_, way_;
    std::array<std::span<V>, BoundaryLayer::modes> z_;
};

} // namespace

std::vector<Field> WallFriction::layerFields()
{
    std::vector<Field> fields = {
        {"layerU", ParticleRange::wall, std::vector<Vec>()}, {"layerWay", ParticleRange::wall, std::vector<Vec>()}};
    for (std::size_t k = 0; k < BoundaryLayer::modes; ++k)
    {
        fields.push_back({"layerMemory" + std::to_string(k), ParticleRange::wall, std::vector<Vec>()});
    }
    return fields;
}

void WallFriction::requireAllOrNoLayerFields(const Particles& particles)
{
    const std::vector<Field> fields = layerFields();
    const auto isThere = [&](const Field& field)
    { return static_cast<int>(particles.values<Vec>(field.name).size()) == particles.nWall; };
    const auto present = std::find_if(fields.begin(), fields.end(), isThere);
    const auto missing = std::find_if_not(fields.begin(), fields.end(), isThere);
    if (present != fields.end() && missing != fields.end())
    {
        throw CaseError(
            "<time>/lagrangian/wall/" + missing->name + ": not found, or of another class; expected it with " +
                present->name + ", as friction at walls needs all of its fields",
            CaseError::Kind::input
        );
    }
}

WallFriction::WallFriction(
    const FluidProperties& fluid, const Tank& tank, double dragRate, const std::vector<Vec>& wallInTank,
    const Particles& particles
)
    : tank_(tank), nu_(fluid.friction.nu), rho0_(fluid.rho0), spacing_(particles.spacing), dragRate_(dragRate)
{
    requireAllOrNoLayerFields(particles);
    const LayerFields<const Vec> layers(particles);
    for (std::size_t w = 0; w < wallInTank.size(); ++w)
    {
        const NearestSurface face = tank.nearestWall(wallInTank[w]);
        if (face.distance > -0.75 * spacing_ && face.distance < 0)
        {
            sites_.push_back(wallInTank[w]);
            wallOf_.push_back(static_cast<int>(w));
            normals_.push_back(face.normal);
            stress_.push_back(layers.at(static_cast<int>(w)).shearStress(rho0_, nu_));
        }
    }
    cleared_.resize(sites_.size());
    if (!sites_.empty())
    {
        grid_.build(sites_, 1.5 * spacing_);
    }
}

void WallFriction::findNear(const Particles& particles, const SolverFrame& frame, double margin)
{
    near_.clear();
    const double reach = spacing_ + margin;
    const Vec low = tank_.box().min().array() + reach, high = tank_.box().max().array() - reach;
    const bool wallsAreTheBox = tank_.isBox() && tank_.bodies().empty();
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        const Vec X = frame.toTank(particles.r[i]);
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
        grid_.forEachNear(
            X, reach + spacing_,
            [&](int site)
            {
                const double distance2 = (X - sites_[site]).squaredNorm();
                if (distance2 < least)
                {
                    least = distance2;
                    nearest = site;
                }
            }
        );
        if (nearest >= 0)
        {
            near_.push_back({static_cast<int>(i), nearest, face.normal, face.normal.dot(X) - face.distance});
        }
    }
}

void WallFriction::advance(
    Particles& particles, const std::vector<WallContact>& contact, const SolverFrame& frame, double dt
)
{
    const BoundaryLayer::Step step(dt);
    const LayerFields<Vec> layers(particles);
    const Vec spin = frame.spin();
    parallelFor(
        static_cast<std::ptrdiff_t>(sites_.size()),
        [&](std::ptrdiff_t site)
        {
            const int w = wallOf_[site];
            if (contact[w].share < wetShare)
            {
                if (!cleared_[site])
                {
                    layers.put(w, BoundaryLayer());
                    stress_[site].setZero();
                    cleared_[site] = true;
                }
                return;
            }
            cleared_[site] = false;
            // The tank's velocity where the liquid is seen, which is not quite that of the wall where the tank
            // turns.
            const Vec carried = particles.v[particles.nFluid + w] + spin.cross(contact[w].away);
            const Vec u = frame.alongTank(contact[w].velocity - carried);
            BoundaryLayer layer = layers.at(w);
            layer.advance(u - u.dot(normals_[site]) * normals_[site], step);
            layers.put(w, layer);
            stress_[site] = layer.shearStress(rho0_, nu_);
        }
    );
}

void WallFriction::addTo(const Particles& particles, const SolverFrame& frame, std::vector<Vec>& acceleration) const
{
    const double perStress = 1 / (rho0_ * spacing_);
    parallelFor(
        static_cast<std::ptrdiff_t>(near_.size()),
        [&](std::ptrdiff_t k)
        {
            const Near& near = near_[k];
            const int i = near.particle;
            if (near.normal.dot(frame.toTank(particles.r[i])) - near.offset < spacing_)
            {
                acceleration[i] -= perStress * frame.fromTankAxes(stress_[near.site]);
            }
        }
    );
    if (dragRate_ != 0)
    {
        parallelFor(
            particles.nFluid,
            [&](std::ptrdiff_t i) { acceleration[i] -= dragRate_ * frame.relative(particles.v[i], particles.r[i]); }
        );
    }
}

} // namespace slosh
