// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/samplePoint.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

/// Distance in the directions that are not empty: a probe may stand anywhere in the slice of a 2D scene.
Vec inPlane(const Snapshot& snapshot, Vec r)
{
    if (const int d = snapshot.scene().tank.emptyDirection(); d >= 0)
    {
        r[d] = 0;
    }
    return r;
}

/// Calls f(index, r - r_b, W) for the particles within the support of r (solver coordinates): those of `grid`, whose
/// index 0 is the particle `first`.
template <class F>
void forNear(const Snapshot& snapshot, const CellGrid& grid, std::ptrdiff_t first, const Vec& r, const F& f)
{
    const Kernel& kernel = snapshot.scene().kernel;
    const double R = kernel.supportRadius();
    grid.forEachNear(
        r, R,
        [&](int i)
        {
            const std::ptrdiff_t k = first + i;
            const Vec x = inPlane(snapshot, r - snapshot.particles().r[k]);
            if (const double r2 = x.squaredNorm(); r2 < R * R)
            {
                f(k, x, kernel.W(std::sqrt(r2)));
            }
        }
    );
}

template <class F>
void forLiquidNear(const Snapshot& snapshot, const Vec& r, const F& f)
{
    forNear(snapshot, snapshot.fluidGrid(), 0, r, f);
}

/// A point of the tank in solver coordinates, moved to the middle of a 2D slice, where the particles are.
Vec solverPoint(const Snapshot& snapshot, Vec X)
{
    const Tank& tank = snapshot.scene().tank;
    if (const int d = tank.emptyDirection(); d >= 0)
    {
        X[d] = tank.box().center()[d];
    }
    return snapshot.frame().fromTank(X);
}

} // namespace

double volumeFraction(const Snapshot& snapshot, const Vec& X)
{
    const Particles& particles = snapshot.particles();
    const Vec r = solverPoint(snapshot, X);
    double liquid = 0, wall = 0;
    forLiquidNear(
        snapshot, r, [&](std::size_t i, const Vec&, double W) { liquid += particles.mass / particles.rho[i] * W; }
    );
    const double wallVolume = particles.mass / snapshot.scene().equationOfState.rho0;
    forNear(
        snapshot, snapshot.wallGrid(), particles.nFluid, r,
        [&](std::size_t, const Vec&, double W) { wall += wallVolume * W; }
    );
    // Deep inside a wall there is nothing left to be filled.
    return wall < 0.99 ? liquid / (1 - wall) : 0;
}

LiquidMean liquidMean(const Snapshot& snapshot, const Vec& X)
{
    const Particles& particles = snapshot.particles();
    const Vec r = solverPoint(snapshot, X);
    const Vec b = snapshot.bodyForce().onRestingLiquid(r);
    const Vec omega = snapshot.frame().spin();
    LiquidMean mean;
    double sum = 0;
    forLiquidNear(
        snapshot, r,
        [&](std::size_t i, const Vec& x, double W)
        {
            mean.velocity += (particles.v[i] + omega.cross(x)) * W;
            mean.pressure += (particles.p[i] + particles.rho[i] * b.dot(x)) * W;
            sum += W;
        }
    );
    if (sum > 0)
    {
        mean.velocity /= sum;
        mean.pressure /= sum;
    }
    return mean;
}

double pressureAt(const Snapshot& snapshot, const Vec& X)
{
    if (volumeFraction(snapshot, X) < 0.5)
    {
        return 0;
    }
    const double p = liquidMean(snapshot, X).pressure;
    const Scene& scene = snapshot.scene();
    const bool isAtWall = scene.tank.distanceToWall(X) < snapshot.particles().spacing / 2;
    return isAtWall && !scene.wallSuction ? std::max(p, 0.0) : p;
}

namespace
{

double volumeFractionAt(const Snapshot& snapshot, const Vec& X, double z)
{
    return volumeFraction(snapshot, Vec(X.x(), X.y(), z));
}

/// The topmost z of F = 1/2 on the vertical through X, found in steps of a quarter of a spacing.
double topmostHalf(const Snapshot& snapshot, const Vec& X)
{
    const auto [bottom, top] = snapshot.scene().tank.verticalExtent(X);
    const double step = snapshot.particles().spacing / 4;
    const auto isLiquid = [&](double z) { return volumeFractionAt(snapshot, X, z) >= 0.5; };
    double above = top;
    if (isLiquid(above))
    {
        return above;
    }
    double below = above - step;
    while (!isLiquid(below))
    {
        if (below <= bottom)
        {
            return bottom;
        }
        above = below;
        below = std::max(below - step, bottom);
    }
    for (int k = 0; k < 40; ++k)
    {
        const double middle = (above + below) / 2;
        (isLiquid(middle) ? below : above) = middle;
    }
    return below;
}

} // namespace

double surfaceLevel(const Snapshot& snapshot, const Vec& X)
{
    const auto [lowest, highest] = snapshot.scene().tank.verticalExtent(X);
    const double R = snapshot.scene().kernel.supportRadius();
    const double surface = topmostHalf(snapshot, X);
    const double bottom = std::max(surface - R, lowest);
    const double top = std::min(surface + R, highest);
    const int n = static_cast<int>((top - bottom) / (snapshot.particles().spacing / 8)) + 1;
    const double dz = (top - bottom) / n;
    double volume = 0;
    for (int k = 0; k < n; ++k)
    {
        const double z = bottom + (k + 0.5) * dz;
        const double F = volumeFractionAt(snapshot, X, z);
        if (F < 0.5 && z < surface)
        {
            return surface;
        }
        volume += F * dz;
    }
    return bottom + volume;
}

} // namespace slosh
