// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/initialFields.hpp"

#include "dictionary/Dictionary.hpp"
#include "dictionary/expression.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace slosh
{

namespace
{

namespace initialFields
{

constexpr Key constant{
    .name = "A0",
    .leftOut = "none",
    .example = "1",
    .sentence = "any name: a constant for the formulas",
    .anyName = true};
constexpr Key U{
    .name = "U",
    .leftOut = "at rest (liquidAtRest)",
    .example = "(\"-$A0*x\" \"0\" \"$A0*z\")",
    .unit = unit::velocity,
    .sentence = "in the tank's frame; not together with liquidAtRest"};
constexpr Key p{
    .name = "p",
    .leftOut = "hydrostatic",
    .example = "\"500*(1 - x^2 - z^2)\"",
    .unit = unit::pressure,
    .sentence = "the density follows from the equation of state"};
constexpr Key dictionary{
    .name = "initialFields",
    .leftOut = "none",
    .sentence = "initial velocity and pressure of the liquid as formulas of the tank's coordinates x y z, [m], with "
                "the functions of #eval",
    .entries =
        [] {
            return Keys{constant, U, p};
        },
    .alternative = true};

} // namespace initialFields

/// The formula at X, or an error at the entry it stands in.
double valueAt(const Vec& X, const std::string& formula, const Dictionary& dict, const Key& key)
{
    const auto constant = [&](const std::string& name)
    {
        if (!dict.has(name))
        {
            throw std::invalid_argument("'$" + name + "' is not set in the same dictionary");
        }
        return dict.scalar(name, unit::none);
    };
    double value = 0;
    try
    {
        value = evaluateExpression(formula, constant, {{"x", X.x()}, {"y", X.y()}, {"z", X.z()}});
    }
    catch (const std::invalid_argument& why)
    {
        throw dict.errorAt(
            key, "is \"" + formula + "\": " + why.what() + "; expected a formula in x, y and z, e.g. \"0.5*(1 - x^2)\""
        );
    }
    if (!std::isfinite(value))
    {
        std::ostringstream message;
        message << "\"" << formula << "\" is not finite at (" << X.transpose() << ")";
        throw dict.errorAt(key, message.str());
    }
    return value;
}

} // namespace

Key initialFieldsKey()
{
    return initialFields::dictionary;
}

Key initialVelocityKey()
{
    return initialFields::U;
}

Key initialPressureKey()
{
    return initialFields::p;
}

void setInitialFields(
    const Dictionary& dict, const Tank& tank, const TaitEquation& equationOfState, Particles& particles
)
{
    using initialFields::p;
    using initialFields::U;
    const std::ptrdiff_t n = particles.nFluid;
    if (dict.has(U))
    {
        const std::vector<std::string> formulas = dict.words(U);
        if (formulas.size() != 3)
        {
            throw dict.errorAt(
                U, "has " + std::to_string(formulas.size()) + " formulas; expected three, e.g. (\"-x\" \"0\" \"z\")"
            );
        }
        for (std::ptrdiff_t i = 0; i < n; ++i)
        {
            for (const int d : tank.directions())
            {
                particles.v[i][d] = valueAt(particles.r[i], formulas[d], dict, U);
            }
        }
    }
    if (dict.has(p))
    {
        const std::string formula = dict.word(p);
        for (std::ptrdiff_t i = 0; i < n; ++i)
        {
            particles.p[i] = valueAt(particles.r[i], formula, dict, p);
            if (!(particles.p[i] > -equationOfState.B()))
            {
                std::ostringstream message;
                message << "is " << particles.p[i] << " Pa at (" << particles.r[i].transpose()
                        << "); expected more than -B (Tait's equation), " << -equationOfState.B() << " Pa";
                throw dict.errorAt(p, message.str());
            }
            particles.rho[i] = equationOfState.rho(particles.p[i]);
        }
    }
    dict.refuseUnknown(initialFields::dictionary.entries());
}

} // namespace slosh
