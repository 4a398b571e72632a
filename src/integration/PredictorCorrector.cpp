// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/PredictorCorrector.hpp"

#include "base/parallel.hpp"

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
    parallelFor(
        particles.nFluid,
        [&](std::ptrdiff_t i)
        {
            particles.v[i] = v_[i] + dt * rates.acceleration[i];
            particles.rho[i] = rho_[i] + dt * rates.densityRate[i];
            particles.r[i] = r_[i] + dt / 2 * (v_[i] + particles.v[i]);
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
    "predictorCorrector",
    "That of Monaghan (1989) and Cao et al. 2014, of second order: two evaluations of the rates a step",
    makePredictorCorrector};
}

} // namespace slosh
