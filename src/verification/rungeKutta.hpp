// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace slosh
{

/// y(t + dt) of y' = rate(t, y) by the classical fourth-order Runge-Kutta method; k1 = rate(t, y), which the caller may
/// want for other ends. The error of a step is of order dt^5. A State can be added and multiplied with a number.
template <class State, class Rate>
State rungeKutta4Step(const Rate& rate, double t, const State& y, const State& k1, double dt)
{
    const State k2 = rate(t + dt / 2, State(y + dt / 2 * k1));
    const State k3 = rate(t + dt / 2, State(y + dt / 2 * k2));
    const State k4 = rate(t + dt, State(y + dt * k3));
    return y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

/// s(t) of the scalar equation s' = rate(s), s(0) = 0, by that method in equal steps no longer than `longestStep`; its
/// error falls as longestStep^4. t in s, t >= 0.
template <class Rate>
double integrateRungeKutta4(const Rate& rate, double t, double longestStep)
{
    const double steps = std::ceil(t / longestStep);
    const double dt = steps > 0 ? t / steps : 0;
    double s = 0;
    for (double n = 0; n < steps; ++n)
    {
        s = rungeKutta4Step([&](double, double at) { return rate(at); }, n * dt, s, rate(s), dt);
    }
    return s;
}

} // namespace slosh
