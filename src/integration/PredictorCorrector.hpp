#pragma once

#include "particles/Particles.hpp"
#include "physics/Rates.hpp"

#include <vector>

namespace slosh
{

/// Predictor-corrector of Monaghan (1989), Cao et al. 2014: second order, two evaluations of the rates a step.
///   predict: v' = v + dt/2 a(t), rho' = rho + dt/2 D(t), r' = r + dt/2 v
///   correct: v1 = v + dt a',     rho1 = rho + dt D',     r1 = r + dt (v + v1)/2,   a', D' at t + dt/2
/// Keeps the state at the start of the step: correct() needs it, and a step that went wrong is undone with restore().
class PredictorCorrector
{
public:
    void predict(Particles& particles, const Rates& rates, double dt);
    void correct(Particles& particles, const Rates& rates, double dt) const;
    /// Back to the state predict() was given.
    void restore(Particles& particles) const;

    std::size_t bytes() const;

private:
    std::vector<Vec> r_, v_;
    std::vector<double> rho_;
};

} // namespace slosh
