// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/liquidEnergies.hpp"

#include "base/parallel.hpp"

#include <functional>

namespace slosh
{

LiquidEnergies liquidEnergies(const Particles& particles, const TaitEquation& equationOfState, const Vec& gravity,
                              Frame frame, const RigidState& tank, double thickness)
{
    const bool inTank = frame == Frame::tank;
    LiquidEnergies sum = parallelReduce(
        particles.nFluid, LiquidEnergies{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            LiquidEnergies e;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const Vec& r = particles.r[i];
                const Vec carried = tank.velocityAt(pointInTank(r, frame, tank));
                const Vec v = inTank ? Vec(carried + tank.R * particles.v[i]) : particles.v[i];
                e.kineticInTank += (v - carried).squaredNorm() / 2;
                e.kinetic += v.squaredNorm() / 2;
                e.potential -= gravity.dot(inTank ? tank.pointToInertial(r) : r);
            }
            return e;
        },
        [](const LiquidEnergies& a, const LiquidEnergies& b) {
            return LiquidEnergies{a.kineticInTank + b.kineticInTank, a.kinetic + b.kinetic, a.potential + b.potential};
        });
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
           parallelReduce(
               particles.nFluid, 0.0,
               [&](std::ptrdiff_t begin, std::ptrdiff_t end)
               {
                   double sum = 0;
                   for (std::ptrdiff_t i = begin; i < end; ++i)
                   {
                       sum += equationOfState.energy(particles.rho[i]);
                   }
                   return sum;
               },
               std::plus<>());
}

} // namespace slosh
