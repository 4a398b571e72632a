// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/PredictorCorrector.hpp"

#include "base/parallel.hpp"
#include "particles/numbersOf.hpp"

namespace slosh
{

void PredictorCorrector::begin(RightHandSides& equations)
{
    equations.evaluate(Wanted::both, Stage::begin);
}

void PredictorCorrector::step(RightHandSides& equations, double dt)
{
    Particles& particles = equations.state();
    const Rates& rates = equations.rates();
    halfStep(particles, rates, dt);
    equations.evaluate(Wanted::both, Stage::halfWay);
    parallelBlocks(
        particles.nFluid, particlesPerBlock,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            const auto of = [=](auto& field) { return numbersOf(field, begin, end); };
            of(particles.v) = of(v_) + dt * of(rates.acceleration);
            of(particles.rho) = of(rho_) + dt * of(rates.densityRate);
            of(particles.r) = of(r_) + dt / 2 * (of(v_) + of(particles.v));
        }
    );
}

static std::unique_ptr<TimeIntegrator> makePredictorCorrector()
{
    return std::make_unique<PredictorCorrector>();
}

namespace choices
{
extern const TimeIntegrator::Choice predictorCorrector = {
    "predictorCorrector", "Second order, Monaghan (1989), Cao et al. 2014: two evaluations of the rates per step",
    makePredictorCorrector};
}

} // namespace slosh
