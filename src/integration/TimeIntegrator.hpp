// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Choice.hpp"
#include "particles/Particles.hpp"
#include "physics/Rates.hpp"

#include <memory>
#include <string>
#include <vector>

namespace slosh
{

/// Of a step.
enum class Stage
{
    begin,
    halfWay, ///< the acceleration there carries the liquid across: forces that depend on time are means over the step
    end
};

/// What is integrated: particles and the right-hand sides of their equations.
class RightHandSides
{
public:
    virtual ~RightHandSides() = default;

    virtual Particles& state() = 0;
    /// What evaluate() found last.
    virtual const Rates& rates() const = 0;
    /// The rates of the state as it is now, which is that at this stage of the step.
    virtual void evaluate(Wanted wanted, Stage stage) = 0;
};

/// One step after the other of v' = a, r' = v, rho' = D. Keeps the state at the start of the step, so that a step that
/// went wrong can be undone.
class TimeIntegrator
{
public:
    virtual ~TimeIntegrator() = default;

    /// An integrator by its name, timeIntegration in system/sphSchemes. Its source has the class and this;
    /// CMakeLists.txt lists it.
    using Choice = slosh::Choice<std::unique_ptr<TimeIntegrator> (*)()>;
    static const std::vector<Choice>& choices();
    static std::vector<std::string> names() { return namesOf(choices()); }
    /// The one called `name`, one of names().
    static std::unique_ptr<TimeIntegrator> make(const std::string& name) { return choiceNamed(choices(), name).read(); }

    /// The largest c0 dt/h at which it is stable with the paper's kernel and viscosity, alpha = 0.03, as measured; a
    /// third less with the cubic spline (docs/stability.md). The default maxCo = 0.25 keeps well below.
    virtual double largestStableCo() const = 0;
    /// At which none of the measured kernels and viscosities is stable (docs/stability.md).
    virtual double unstableCo() const = 0;

    /// What a laminar viscosity counts for in stableTimeStep(): 2 where forces are of an extrapolated velocity, which
    /// bears half the step.
    virtual double viscosityFactor() const { return 1; }

    /// The density rate that a step takes is that half-way, not the mean of those at its ends.
    virtual bool takesDensityRateHalfWay() const { return true; }

    /// Before the length of the step is chosen: afterwards the rates hold the acceleration it is chosen by.
    virtual void begin(RightHandSides& equations) = 0;
    /// Of length dt, [s].
    virtual void step(RightHandSides& equations, double dt) = 0;
    /// Discards what earlier steps left: after particles were sorted or changed, and after a state was written, so that
    /// a restart from it takes the same steps.
    virtual void forget() {}

    /// Back to the state the last step started from.
    void restore(Particles& particles) const;
    std::size_t bytes() const;
    const std::vector<Vec>& velocityBefore() const { return v_; } ///< at the start of the last step

protected:
    /// Keeps the state and takes it half a step on with the rates there: r + dt/2 v, v + dt/2 a, rho + dt/2 D.
    void halfStep(Particles& particles, const Rates& rates, double dt);

    std::vector<Vec> r_, v_;
    std::vector<double> rho_;
};

} // namespace slosh
