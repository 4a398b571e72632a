// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/liquidState.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

LiquidState liquidState(const Snapshot& snapshot)
{
    const Particles& particles = snapshot.particles();
    const Scene& scene = snapshot.scene();
    const SolverFrame& frame = snapshot.frame();
    const std::ptrdiff_t n = particles.nFluid;
    LiquidState sum;
    Vec squares = Vec::Zero();
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        const Vec& r = particles.r[i];
        const Vec X = frame.toTank(r);
        sum.centreInTank += X;
        squares += X.cwiseAbs2();
        sum.extent.extend(X);
        sum.centre += frame.toInertial(r);
        sum.velocity += frame.absolute(particles.v[i], r);
        const double deviation = std::abs(particles.rho[i] / scene.equationOfState.rho0 - 1);
        sum.largestDeviation = std::max(sum.largestDeviation, deviation);
        sum.rmsDeviation += deviation * deviation;
    }
    sum.centreInTank /= static_cast<double>(n);
    sum.centre /= static_cast<double>(n);
    const Vec variance = squares / static_cast<double>(n) - sum.centreInTank.cwiseAbs2();
    sum.semiAxes = ((scene.tank.dim() + 2) * variance.cwiseMax(0)).cwiseSqrt();
    for (const int d : scene.tank.directions())
    {
        sum.extent.min()[d] -= particles.spacing / 2;
        sum.extent.max()[d] += particles.spacing / 2;
    }
    sum.velocity /= static_cast<double>(n);
    sum.rmsDeviation = std::sqrt(sum.rmsDeviation / static_cast<double>(n));
    return sum;
}

} // namespace slosh
