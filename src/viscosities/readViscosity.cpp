// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscosities/readViscosity.hpp"

#include "base/numberText.hpp"

namespace slosh
{

namespace
{

template <class T>
ViscosityChoice read(const Dictionary& entries, const TaitEquation& state)
{
    T viscosity = T::of(state);
    for (const auto& coefficient : T::coefficients)
    {
        viscosity.*coefficient.value = entries.scalar(coefficient.key, coefficient.unit, notNegative);
    }
    return viscosity;
}

template <class... T>
std::vector<ViscosityType> tableOf(const std::variant<T...>&)
{
    return {{T::name, T::sentence, read<T>}...};
}

template <class... T>
void allowCoefficients(const Dictionary& entries, const std::variant<T...>&)
{
    const auto allow = [&](const auto& coefficients)
    {
        for (const auto& coefficient : coefficients)
        {
            entries.allow({std::string(coefficient.key)});
        }
    };
    (allow(T::coefficients), ...);
}

} // namespace

const std::vector<ViscosityType>& viscosityTypes()
{
    static const std::vector<ViscosityType> table = tableOf(ViscosityChoice());
    return table;
}

ViscosityChoice readViscosity(const Dictionary& entries, const TaitEquation& state)
{
    allowCoefficients(entries, ViscosityChoice());
    const ViscosityChoice viscosity = choose(entries, "type", viscosityTypes(), "viscosity type").read(entries, state);
    entries.allow({"walls"});
    entries.refuseUnknown();
    return viscosity;
}

std::string describe(const ViscosityChoice& viscosity)
{
    return std::visit(
        [](const auto& type)
        {
            std::string text(type.name);
            for (const auto& coefficient : type.coefficients)
            {
                const bool hasUnit = coefficient.unit.exponent != unit::none.exponent;
                text += ", " + std::string(coefficient.key) + " = " + numberText(type.*coefficient.value, 4) +
                        (hasUnit ? " " + std::string(coefficient.unit.name) : "");
            }
            return text;
        },
        viscosity
    );
}

bool isNone(const ViscosityChoice& viscosity)
{
    return std::holds_alternative<NoViscosity>(viscosity);
}

} // namespace slosh
