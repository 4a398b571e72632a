// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/samplePoint.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

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
    const Kernel& kernel = snapshot.scene().kernel;
    double liquid = 0, wall = 0;
    snapshot.forLiquidNear(
        r, [&](std::ptrdiff_t b, const Vec& x) { liquid += particles.mass / particles.rho[b] * kernel.W(x.norm()); }
    );
    const double wallVolume = particles.mass / snapshot.scene().equationOfState.rho0;
    snapshot.forWallsNear(r, [&](std::ptrdiff_t, const Vec& x) { wall += wallVolume * kernel.W(x.norm()); });
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
    snapshot.forLiquidNear(
        r,
        [&](std::ptrdiff_t i, const Vec& x)
        {
            const double W = snapshot.scene().kernel.W(x.norm());
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
