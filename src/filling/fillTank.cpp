// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fillTank.hpp"

#include "base/CaseError.hpp"
#include "filling/latticeSites.hpp"
#include "filling/sectionSites.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

LatticeAxis axisAlong(double low, double high, double latticeLength, double dx, int wallLayers)
{
    LatticeAxis axis;
    axis.origin = low;
    axis.spacing = latticeLength / std::max(1.0, std::round(latticeLength / dx));
    axis.first = -wallLayers;
    // The far wall begins where the tank ends, to half a cell.
    axis.last = static_cast<int>(std::lround((high - low) / axis.spacing)) + wallLayers;
    return axis;
}

/// Heights of the layers' centres. Each layer of the liquid weighs the same, so that where pressure has pressed the
/// liquid together the lattice is narrower, too: with an even lattice particles and density contradict each other, and
/// the pressure rings and settles at rho0 g d (rho/rho0)^2.
std::vector<double>
layerHeights(const LatticeAxis& axis, const Tank& tank, const TaitEquation& equationOfState, double gravity)
{
    const double layers = std::round(tank.fillDepth() / axis.spacing);
    const double bottomPressure = equationOfState.hydrostatic(gravity, tank.fillDepth());
    std::vector<double> heights;
    for (int k = axis.first; k < axis.last; ++k)
    {
        const bool isLiquid = k >= 0 && k < layers && gravity > 0 && tank.fill().hasOneSurface();
        heights.push_back(
            isLiquid
                ? tank.fill().level() - equationOfState.depth(gravity, (layers - k - 0.5) / layers * bottomPressure)
                : axis.origin + (k + 0.5) * axis.spacing
        );
    }
    return heights;
}

void refuseThinBodies(const Tank& tank, double dx, double reachOverDx)
{
    for (const auto& body : tank.bodies())
    {
        for (const int d : tank.directions())
        {
            const double thickness = body->bounds().sizes()[d];
            // A side in the tank's wall has no liquid behind it.
            const bool reachesWall = body->bounds().min()[d] <= tank.box().min()[d] + 0.5 * dx ||
                                     body->bounds().max()[d] >= tank.box().max()[d] - 0.5 * dx;
            if (thickness < reachOverDx * dx * (1 - 1e-9) && !reachesWall)
            {
                std::ostringstream message;
                message << "constant/tankProperties: the body " << body->name() << " is " << thickness << " m thick in "
                        << "xyz"[d] << ", less than the kernel's support of " << reachOverDx * dx
                        << " m: liquid on its two sides would interact; expected a particleSpacing of at most "
                        << thickness / reachOverDx << " m (system/blockParticlesDict)";
                throw CaseError(message.str(), CaseError::Kind::input);
            }
        }
    }
}

/// As thin bodies: walls of a section with liquid on both sides. The tip of a wedge is not one.
void refuseThinWalls(const Polygon& section, double dx, double reachOverDx)
{
    const auto n = static_cast<std::ptrdiff_t>(section.corners().size());
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        for (std::ptrdiff_t side = 0; side < n; ++side)
        {
            const Vec2 &x = section.corner(i), &a = section.corner(side), along = section.corner(side + 1) - a;
            const double t = std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
            const Vec2 across = a + t * along - x;
            const bool isItsOwn = side == i || (side + 1) % n == i;
            const double thickness = across.norm();
            if (!isItsOwn && thickness < reachOverDx * dx * (1 - 1e-9) &&
                section.nearest(x + across / 2).distance > 1e-6 * thickness) // not along a side, nor through liquid
            {
                std::ostringstream message;
                message << "the wall in the polygon of constant/tankProperties is " << thickness
                        << " m thick at the corner (" << x.transpose() << "), less than the kernel's support of "
                        << reachOverDx * dx
                        << " m: liquid on its two sides would interact; expected a particleSpacing of at most "
                        << thickness / reachOverDx << " m (system/blockParticlesDict)";
                throw CaseError(message.str(), CaseError::Kind::input);
            }
        }
    }
}

} // namespace

Filling fillTank(
    const Tank& tank, double dx, int wallLayers, double rho0, const TaitEquation& equationOfState, double gravity,
    double reachOverDx
)
{
    Lattice lattice;
    lattice.wallLayers = wallLayers;
    std::array<LatticeAxis, 3>& axes = lattice.axes;
    const Vec low = tank.box().min(), high = tank.box().max();
    const auto refuse = [&](const std::string& what, double length)
    {
        std::ostringstream message;
        message << "system/blockParticlesDict: particleSpacing is " << dx << " m; expected less than the " << what
                << ", " << length << " m";
        throw CaseError(message.str(), CaseError::Kind::input);
    };
    for (const int d : tank.directions())
    {
        const bool vertical = d == 2;
        const double length = high[d] - low[d];
        const double filled = vertical ? tank.fillDepth() : length;
        if (filled < dx * (1 - 1e-9))
        {
            refuse(vertical ? "liquid's depth" : std::string("tank's extent in ") + "xyz"[d], filled);
        }
        axes[d] = axisAlong(low[d], high[d], filled, dx, wallLayers);
    }
    if (const int d = tank.emptyDirection(); d >= 0)
    {
        axes[d] = {low[d], high[d] - low[d], 0, 1};
    }
    double cells = 1;
    for (const LatticeAxis& axis : axes)
    {
        cells *= axis.last - axis.first;
    }
    if (cells > 1e9)
    {
        std::ostringstream message;
        message << "system/blockParticlesDict: particleSpacing is " << dx << " m, which gives " << cells
                << " cells; expected at most 1e9";
        throw CaseError(message.str(), CaseError::Kind::input);
    }
    refuseThinBodies(tank, dx, reachOverDx);
    const auto section = tank.walls().section(dx);
    if (section)
    {
        refuseThinWalls(section->polygon, dx, reachOverDx);
    }

    lattice.heights = layerHeights(axes[2], tank, equationOfState, gravity);
    const ParticleSites sites = section ? sectionSites(tank, *section, lattice) : latticeSites(tank, lattice);
    const std::vector<Vec>&liquid = sites.liquid, &wall = sites.wall;
    if (liquid.empty())
    {
        throw CaseError(
            "system/blockParticlesDict: particleSpacing is too large: no particle fits into the liquid",
            CaseError::Kind::input
        );
    }

    Filling filling;
    Particles& particles = filling.particles;
    particles.resize(static_cast<std::ptrdiff_t>(liquid.size()), static_cast<std::ptrdiff_t>(wall.size()));
    std::copy(liquid.begin(), liquid.end(), particles.r.begin());
    std::copy(wall.begin(), wall.end(), particles.r.begin() + particles.nFluid);
    const double volume = tank.fill().volume() / tank.thickness();
    particles.mass = rho0 * volume / static_cast<double>(liquid.size());
    particles.spacing = std::pow(particles.mass / rho0, 1.0 / tank.dim());
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        const bool isLiquid = i < liquid.size();
        particles.p[i] = isLiquid ? equationOfState.hydrostatic(gravity, tank.fill().depthAt(particles.r[i])) : 0;
        particles.rho[i] = equationOfState.rho(particles.p[i]);
        particles.id[i] = static_cast<int>(isLiquid ? i : i - liquid.size());
    }

    for (std::size_t d = 0; d < 3; ++d)
    {
        filling.spacing[static_cast<Eigen::Index>(d)] = axes[d].spacing;
        const double change = axes[d].spacing / dx - 1;
        if (static_cast<int>(d) != tank.emptyDirection() && std::abs(change) > 1e-9)
        {
            std::ostringstream line;
            line << "spacing in "
                 << "xyz"[d] << ": " << axes[d].spacing << " m, " << 100 * change
                 << " % from the requested one, so that whole cells fit";
            filling.adjustments.push_back(line.str());
        }
    }
    const double cell = std::pow(dx, tank.dim()) * rho0;
    if (const double change = particles.mass / cell - 1; std::abs(change) > 1e-9)
    {
        std::ostringstream line;
        line << "mass of a particle: " << 100 * change << " % from rho0 dx^" << tank.dim()
             << ", so that the total mass is exact";
        filling.adjustments.push_back(line.str());
    }
    const double gap = axes[2].origin + (axes[2].last - wallLayers) * axes[2].spacing - high.z();
    if (std::abs(gap) > 1e-9 * dx && tank.isBox())
    {
        std::ostringstream line;
        line << "roof: wall particles placed " << gap
             << " m off (less than half a spacing), on the lattice of the liquid";
        filling.adjustments.push_back(line.str());
    }
    return filling;
}

} // namespace slosh
