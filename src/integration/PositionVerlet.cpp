// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/PositionVerlet.hpp"

#include "base/parallel.hpp"
#include "particles/numbersOf.hpp"

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
    parallelBlocks(
        particles.nFluid, particlesPerBlock,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            const auto of = [=](auto& field) { return numbersOf(field, begin, end); };
            of(particles.v) = of(v_) + dt * of(rates.acceleration);
            of(particles.r) += dt / 2 * of(particles.v);
            of(particles.rho) += dt / 2 * of(rates.densityRate);
        }
    );
    equations.evaluate(Wanted::densityRate, Stage::end);
    parallelBlocks(
        particles.nFluid, particlesPerBlock,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            const auto of = [=](auto& field) { return numbersOf(field, begin, end); };
            of(particles.rho) = (of(rho_) + of(particles.rho) + dt * of(rates.densityRate)) / 2;
        }
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
    "Second-order drift-kick-drift, one evaluation of each rate per step: stable with three times the step, sound "
    "neither grows nor decays",
    makePositionVerlet};
}

} // namespace slosh
