// SPDX-License-Identifier: GPL-3.0-or-later
// A wave across its own direction, and a doubly periodic box of the liquid that carries it.
#pragma once

#include "physics/Pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace slosh
{

inline constexpr int n = 32;                           // particles along an edge of the box
inline constexpr double taitGamma = 7, background = 1; // pressure that no particles pull
inline constexpr double disorder = 0.05;               // dx, at the start of a run

template <int dim>
using Point = std::array<double, dim>;

/// v = sin(k . r) along t.
template <int dim>
struct Wave
{
    Point<dim> k{}, t{};

    double k2() const { return dot(k, k); }
    double phase(const Point<dim>& r) const { return dot(k, r); }
    Point<dim> velocity(const Point<dim>& r) const
    {
        Point<dim> v = t;
        for (double& component : v)
        {
            component *= std::sin(phase(r));
        }
        return v;
    }

    static Wave alongAxis(int wavelength)
    {
        Wave wave;
        wave.k[1] = 2 * std::numbers::pi / wavelength;
        wave.t[0] = 1;
        return wave;
    }

    static Wave alongDiagonal(int wavelength)
    {
        Wave wave = alongAxis(wavelength);
        wave.k[0] = wave.k[1];
        wave.t[0] = std::sqrt(0.5);
        wave.t[1] = -wave.t[0];
        return wave;
    }
};

template <int dim>
Neighbour<dim, double> particle(const Point<dim>& v, double p, double rho)
{
    Neighbour<dim, double> record{};
    record.P = p / (rho * rho);
    record.s = 1 / rho;
    record.v = v;
    return record;
}

/// Calls f(pair) of two particles that are r_ab = h x apart.
template <int dim, class F>
void withPair(const Neighbour<dim, double>& a, const Neighbour<dim, double>& b, const Point<dim>& x, const F& f)
{
    Point<dim> v;
    for (std::size_t d = 0; d < dim; ++d)
    {
        v[d] = a.v[d] - b.v[d];
    }
    f(Pair<dim, double, false>{a, b, x, dot(x, x), dot(v, x)});
}

/// A doubly periodic box of the liquid of Eq. 1, with the pressure of Tait's equation and a background pressure, so
/// that no pair of particles pulls. Position Verlet, as src/integration/PositionVerlet.hpp.
template <class K, class Term>
class PeriodicBox
{
public:
    PeriodicBox(const Wave<2>& wave, double h, double c0, const Term& Pi) : wave_(wave), h_(h), c0_(c0), Pi_(Pi)
    {
        std::mt19937 random(17);
        std::uniform_real_distribution<double> offset(-disorder, disorder);
        for (std::size_t i = 0; i < size; ++i)
        {
            r_[i] = {static_cast<double>(i % n) + offset(random), static_cast<double>(i / n) + offset(random)};
            v_[i] = wave.velocity(r_[i]);
        }
        findPairs();
        evaluateDensityRates();
    }

    /// A of v = A sin(k . r) along t, by least squares.
    double amplitude() const { return amplitudeOf(v_); }
    /// dA/dt by the term alone, half a step ago.
    double viscousRate() const { return amplitudeOf(viscous_); }

    void step(double dt)
    {
        drift(dt / 2);
        evaluateAccelerations();
        for (std::size_t i = 0; i < size; ++i)
        {
            for (std::size_t d = 0; d < 2; ++d)
            {
                v_[i][d] += dt * (inviscid_[i][d] + viscous_[i][d]);
            }
        }
        drift(dt / 2);
        evaluateDensityRates();
        for (std::size_t i = 0; i < size; ++i)
        {
            rho_[i] += dt / 2 * (densityRate_[i] - oldDensityRate_[i]);
        }
        double fastest2 = 0;
        for (const Point<2>& v : v_)
        {
            fastest2 = std::max(fastest2, dot(v, v));
        }
        displacement_ += std::sqrt(fastest2) * dt;
        if (displacement_ > 0.4 * skin)
        {
            findPairs();
        }
    }

private:
    static constexpr std::size_t size = n * n;
    static constexpr double skin = 0.4; // in dx; twice a displacement

    Point<2> difference(std::size_t a, std::size_t b) const
    {
        Point<2> x;
        for (std::size_t d = 0; d < 2; ++d)
        {
            x[d] = r_[a][d] - r_[b][d];
            x[d] -= n * std::round(x[d] / n);
        }
        return x;
    }

    double amplitudeOf(const std::vector<Point<2>>& field) const
    {
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < size; ++i)
        {
            const double s = std::sin(wave_.phase(r_[i]));
            sum += dot(field[i], wave_.t) * s;
            squares += s * s;
        }
        return sum / squares;
    }

    void drift(double dt)
    {
        for (std::size_t i = 0; i < size; ++i)
        {
            for (std::size_t d = 0; d < 2; ++d)
            {
                r_[i][d] += dt * v_[i][d];
            }
            rho_[i] += dt * densityRate_[i];
        }
    }

    void findPairs()
    {
        const double reach = K::supportRatio * h_ + skin;
        pairs_.clear();
        for (std::uint16_t a = 0; a < size; ++a)
        {
            for (std::uint16_t b = 0; b < a; ++b)
            {
                const Point<2> x = difference(a, b);
                if (dot(x, x) < reach * reach)
                {
                    pairs_.emplace_back(a, b);
                }
            }
        }
        displacement_ = 0;
    }

    /// Calls f(a, b, pair, F) of each two particles within the support, grad_a W_ab = F r_ab/h.
    template <class F>
    void forPairs(const F& f)
    {
        const double factor = K::alpha(2) / std::pow(h_, 3);
        for (std::size_t i = 0; i < size; ++i)
        {
            const double p = c0_ * c0_ / taitGamma * (std::pow(rho_[i], taitGamma) - 1) + background;
            record_[i] = particle<2>(v_[i], p, rho_[i]);
        }
        for (const auto& [a, b] : pairs_)
        {
            Point<2> x = difference(a, b);
            x[0] /= h_;
            x[1] /= h_;
            const auto i = a, j = b;
            withPair<2>(
                record_[a], record_[b], x,
                [&](const Pair<2, double, false>& pair)
                {
                    if (pair.q2 < K::supportRatio * K::supportRatio)
                    {
                        f(i, j, pair, factor * K::dfByQ(pair.q2));
                    }
                }
            );
        }
    }

    void evaluateAccelerations()
    {
        inviscid_.assign(size, {});
        viscous_.assign(size, {});
        forPairs(
            [&](std::size_t a, std::size_t b, const Pair<2, double, false>& pair, double F)
            {
                const double pressure = (pair.a.P + pair.b.P) * F, viscous = Pi_(pair, pair.approach) * F;
                for (std::size_t d = 0; d < 2; ++d)
                {
                    inviscid_[a][d] -= pressure * pair.x[d];
                    inviscid_[b][d] += pressure * pair.x[d];
                    viscous_[a][d] -= viscous * pair.x[d];
                    viscous_[b][d] += viscous * pair.x[d];
                }
            }
        );
    }

    void evaluateDensityRates()
    {
        oldDensityRate_ = densityRate_;
        densityRate_.assign(size, 0);
        forPairs(
            [&](std::size_t a, std::size_t b, const Pair<2, double, false>& pair, double F)
            {
                const double flow = pair.approach * F;
                densityRate_[a] += rho_[a] / rho_[b] * flow;
                densityRate_[b] += rho_[b] / rho_[a] * flow;
            }
        );
    }

    Wave<2> wave_;
    double h_, c0_;
    Term Pi_;
    std::vector<Point<2>> r_{size}, v_{size}, inviscid_{size}, viscous_{size};
    std::vector<double> rho_ = std::vector<double>(size, 1), densityRate_ = std::vector<double>(size, 0),
                        oldDensityRate_;
    std::vector<Neighbour<2, double>> record_{size};
    std::vector<std::pair<std::uint16_t, std::uint16_t>> pairs_;
    double displacement_ = 0;
};

} // namespace slosh
