// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integration/TimeIntegrator.hpp"

namespace slosh
{

/// Position Verlet, drift-kick-drift, second order; one sum of each kind a step, each at its own instant:
///   r' = r + dt/2 v,      rho' = rho + dt/2 D       half a step with the density rate at its start
///   v1 = v + dt a'                                  a' of (r', rho') and of v + dt/2 a, extrapolated
///   r1 = r' + dt/2 v1,    rho1 = rho' + dt/2 D1     D1 of (r1, v1) and of rho + dt D; it starts the next step
/// Sound neither grows nor decays while omega dt < 2 (the predictor-corrector lets it grow at any step). The density
/// rate at the start is that of the end of the step before; where that is not known any more (forget()) all is
/// evaluated at the start.
class PositionVerlet final : public TimeIntegrator
{
public:
    double largestStableCo() const override { return 2.18; }
    double unstableCo() const override { return 2.24; }
    double viscosityFactor() const override { return 2; }
    bool takesDensityRateHalfWay() const override { return false; }
    void begin(RightHandSides& equations) override;
    void step(RightHandSides& equations, double dt) override;
    void forget() override { knowsRates_ = false; }

private:
    bool knowsRates_ = false;
};

} // namespace slosh
