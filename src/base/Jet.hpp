// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace slosh
{

/// A number that depends on time, with its first and second derivative: f(t), f'(t), f''(t). Arithmetic follows the
/// rules of differentiation, so that a formula written once gives velocity and acceleration exactly.
struct Jet
{
    double f = 0, d = 0, dd = 0;

    Jet() = default;
    Jet(double constant) : f(constant) {} // NOLINT: a constant is a Jet
    Jet(double value, double first, double second) : f(value), d(first), dd(second) {}

    static Jet time(double t) { return {t, 1, 0}; }

    Jet& operator+=(const Jet& b) { return *this = Jet(f + b.f, d + b.d, dd + b.dd); }
    Jet& operator-=(const Jet& b) { return *this = Jet(f - b.f, d - b.d, dd - b.dd); }
    Jet& operator*=(const Jet& b) { return *this = Jet(f * b.f, d * b.f + f * b.d, dd * b.f + 2 * d * b.d + f * b.dd); }
    Jet& operator/=(const Jet& b)
    {
        const double q = f / b.f;
        const double q1 = (d - q * b.d) / b.f;
        return *this = Jet(q, q1, (dd - 2 * q1 * b.d - q * b.dd) / b.f);
    }
    Jet operator-() const { return {-f, -d, -dd}; }
    friend Jet operator+(Jet a, const Jet& b) { return a += b; }
    friend Jet operator-(Jet a, const Jet& b) { return a -= b; }
    friend Jet operator*(Jet a, const Jet& b) { return a *= b; }
    friend Jet operator/(Jet a, const Jet& b) { return a /= b; }
};

/// g(f(t)) of a function g with derivatives g1, g2 at f.
inline Jet chain(const Jet& x, double g, double g1, double g2)
{
    return {g, g1 * x.d, g2 * x.d * x.d + g1 * x.dd};
}

inline Jet sin(const Jet& x)
{
    return chain(x, std::sin(x.f), std::cos(x.f), -std::sin(x.f));
}

inline Jet cos(const Jet& x)
{
    return chain(x, std::cos(x.f), -std::sin(x.f), -std::cos(x.f));
}

inline Jet exp(const Jet& x)
{
    return chain(x, std::exp(x.f), std::exp(x.f), std::exp(x.f));
}

inline Jet log(const Jet& x)
{
    return chain(x, std::log(x.f), 1 / x.f, -1 / (x.f * x.f));
}

} // namespace slosh

template <>
struct Eigen::NumTraits<slosh::Jet> : Eigen::NumTraits<double>
{
    using Real = slosh::Jet;
    using NonInteger = slosh::Jet;
    using Nested = slosh::Jet;
    enum
    {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 3,
        AddCost = 3,
        MulCost = 9
    };
};
