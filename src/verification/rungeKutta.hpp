#pragma once

#include <cmath>

namespace slosh
{

/// s(t) of the scalar equation s' = rate(s), s(0) = 0, by the classical fourth-order Runge-Kutta method in equal steps
/// no longer than `longestStep`; its error falls as longestStep^4. t in s, t >= 0.
template <class Rate>
double integrateRungeKutta4(const Rate& rate, double t, double longestStep)
{
    const double steps = std::ceil(t / longestStep);
    const double dt = steps > 0 ? t / steps : 0;
    double s = 0;
    for (double n = 0; n < steps; ++n)
    {
        const double k1 = rate(s);
        const double k2 = rate(s + dt / 2 * k1);
        const double k3 = rate(s + dt / 2 * k2);
        const double k4 = rate(s + dt * k3);
        s += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return s;
}

} // namespace slosh
