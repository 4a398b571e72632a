// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace slosh
{

/// The boundary layer at one place of a wall: what the liquid passing there with the velocity u(t) along the wall has
/// left in it since the place was wetted, and the shear stress, [Pa], on the wall. Independent of spacing, speed of
/// sound and artificial viscosity.
///
/// Laminar, of a plane wall (Stokes 1851; Batchelor, An Introduction to Fluid Dynamics, 4.3): with u = 0 before
/// the wall was wetted,
///   tau = rho sqrt(nu/pi) int (du/ds)/sqrt(t - s) ds.
/// Liquid that comes at U to a dry place begins with a jump, tau = rho U sqrt(nu/(pi t)); in oscillation tau has the
/// amplitude rho U sqrt(nu omega) and leads u by 45 degrees. The kernel is a sum of exponentials, the trapezoidal rule
/// in ln x of
///   1/sqrt(pi t) = (2/pi) int_0^inf exp(-x^2 t) dx,
/// right to 2 % for t from 0.5 ms to 20 s; at earlier ones it stays finite.
///
/// Turbulent, where Re = |u| L/nu > 5e5, L the way since the place was wetted or the flow last turned back: the smooth
/// flat plate's (Prandtl; Schlichting & Gersten, Boundary-Layer Theory, 18.2)
///   tau = rho c_f |u| u/2,   c_f = 0.0592 Re^(-1/5),   Re up to 1e7.
/// Limits: no history of the liquid before it came to this place, no pressure gradient but what u(t) says, smooth
/// walls.
struct BoundaryLayer
{
    static constexpr std::size_t modes = 8;
    static constexpr double transition = 5e5;

    Vec u = Vec::Zero();        ///< now, relative to the wall, [m/s]
    Vec way = Vec::Zero();      ///< int u dt since the flow last turned back, [m]
    std::array<Vec, modes> z{}; ///< int exp(-lambda_k (t - s)) du, [m/s]

    BoundaryLayer() { z.fill(Vec::Zero()); }

    /// lambda_k, [1/s]
    static double rate(std::size_t k)
    {
        const double x = firstX * std::exp(stepOfLnX * static_cast<double>(k));
        return x * x;
    }
    /// The weight of z_k in tau/(rho sqrt(nu)), [1/sqrt(s)]
    static double weight(std::size_t k) { return 2 / std::numbers::pi * stepOfLnX * std::sqrt(rate(k)); }
    /// That of u itself: the modes slower than the first.
    static double weightOfU() { return weight(0) / (std::exp(stepOfLnX) - 1); }

    /// What a step of a given length multiplies with: exp(-lambda dt) and its mean over the step.
    struct Step
    {
        double dt;
        std::array<double, modes> decay, mean;

        explicit Step(double length) : dt(length), decay{}, mean{}
        {
            for (std::size_t k = 0; k < modes; ++k)
            {
                const double x = rate(k) * dt;
                decay[k] = std::exp(-x);
                mean[k] = x > 0 ? -std::expm1(-x) / x : 1;
            }
        }
    };

    /// Over a step at whose end the liquid passes at `next`, u linear in time.
    void advance(const Vec& next, const Step& step)
    {
        const Vec du = next - u;
        for (std::size_t k = 0; k < modes; ++k)
        {
            z[k] = step.decay[k] * z[k] + step.mean[k] * du;
        }
        way = next.dot(way) < 0 ? Vec::Zero().eval() : way;
        way += step.dt * next;
        u = next;
    }

    /// tau, on the wall, [Pa]
    Vec shearStress(double rho, double nu) const
    {
        const double speed = u.norm(), Re = speed * way.norm() / nu;
        if (Re > transition)
        {
            return rho * 0.0592 * std::pow(Re, -0.2) / 2 * speed * u;
        }
        Vec sum = weightOfU() * u;
        for (std::size_t k = 0; k < modes; ++k)
        {
            sum += weight(k) * z[k];
        }
        return rho * std::sqrt(nu) * sum;
    }

private:
    static constexpr double stepOfLnX = 0.9;
    static constexpr double firstX = 0.15; // lambda_0 = 0.0225/s
};

} // namespace slosh
