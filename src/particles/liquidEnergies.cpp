// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/liquidEnergies.hpp"

#include "particles/reduce.hpp"

namespace slosh
{

LiquidEnergies liquidEnergies(
    const Particles& particles, const TaitEquation& equationOfState, const Vec& gravity, const SolverFrame& frame,
    double thickness
)
{
    LiquidEnergies sum = reduceLiquid(
        particles, LiquidEnergies{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            LiquidEnergies e;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec &r = particles.r[i], &v = particles.v[i];
                e.kineticInTank += frame.relative(v, r).squaredNorm() / 2;
                e.kinetic += frame.absolute(v, r).squaredNorm() / 2;
                e.potential -= gravity.dot(frame.toInertial(r));
            }
            return e;
        },
        [](const LiquidEnergies& a, const LiquidEnergies& b) {
            return LiquidEnergies{a.kineticInTank + b.kineticInTank, a.kinetic + b.kinetic, a.potential + b.potential};
        }
    );
    const double mass = particles.mass * thickness;
    sum.kineticInTank *= mass;
    sum.kinetic *= mass;
    sum.potential *= mass;
    sum.internal = internalEnergy(particles, equationOfState, thickness);
    return sum;
}

double internalEnergy(const Particles& particles, const TaitEquation& equationOfState, double thickness)
{
    return particles.mass * thickness *
           sumOverLiquid(particles, [&](std::ptrdiff_t i) { return equationOfState.energy(particles.rho[i]); });
}

} // namespace slosh
