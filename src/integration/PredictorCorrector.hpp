// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integration/TimeIntegrator.hpp"

namespace slosh
{

/// Predictor-corrector of Monaghan (1989), Cao et al. 2014: second order, two evaluations of the rates a step.
///   predict: v' = v + dt/2 a(t), rho' = rho + dt/2 D(t), r' = r + dt/2 v
///   correct: v1 = v + dt a',     rho1 = rho + dt D',     r1 = r + dt (v + v1)/2,   a', D' at t + dt/2
/// Sound grows without viscosity, slowly: by 1 + z^4/8 a step, z = omega dt.
class PredictorCorrector final : public TimeIntegrator
{
public:
    double largestStableCo() const override { return 0.65; }
    double unstableCo() const override { return 0.944; }
    void begin(RightHandSides& equations) override;
    void step(RightHandSides& equations, double dt) override;
};

} // namespace slosh
