// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/PositionVerlet.hpp"

#include "base/parallel.hpp"

namespace slosh
{

void PositionVerlet::begin(RightHandSides& equations)
{
    if (!knowsRates_)
    {
        equations.evaluate(Wanted::both, Stage::begin);
        knowsRates_ = true;
    }
}

void PositionVerlet::step(RightHandSides& equations, double dt)
{
    Particles& particles = equations.state();
    const Rates& rates = equations.rates();
    halfStep(particles, rates, dt);
    equations.evaluate(Wanted::acceleration, Stage::halfWay);
    parallelFor(
        particles.nFluid,
        [&](std::ptrdiff_t i)
        {
            particles.v[i] = v_[i] + dt * rates.acceleration[i];
            particles.r[i] += dt / 2 * particles.v[i];
            particles.rho[i] += dt / 2 * rates.densityRate[i];
        }
    );
    equations.evaluate(Wanted::densityRate, Stage::end);
    parallelFor(
        particles.nFluid,
        [&](std::ptrdiff_t i) { particles.rho[i] = (rho_[i] + particles.rho[i] + dt * rates.densityRate[i]) / 2; }
    );
}

static std::unique_ptr<TimeIntegrator> makePositionVerlet()
{
    return std::make_unique<PositionVerlet>();
}

namespace choices
{
extern const TimeIntegrator::Choice positionVerlet = {
    "positionVerlet",
    "Drift-kick-drift, of second order, one evaluation of each rate a step: bears three times the step, sound neither "
    "grows nor decays",
    makePositionVerlet};
}

} // namespace slosh
