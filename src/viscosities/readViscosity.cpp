// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscosities/readViscosity.hpp"

#include "base/numberText.hpp"
#include "fluid/FluidProperties.hpp"

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
        viscosity.*coefficient.value = entries.scalar(coefficient.key);
    }
    return viscosity;
}

template <class T>
Keys keysOf()
{
    Keys keys;
    for (const auto& coefficient : T::coefficients)
    {
        keys.push_back(coefficient.key);
    }
    return keys;
}

template <class... T>
std::vector<ViscosityType> tableOf(const std::variant<T...>&)
{
    return {{T::name, T::sentence, read<T>, keysOf<T>}...};
}

constexpr Key viscosityType{
    .name = "type", .leftOut = "by scheme: smallWaves none, else artificial", .example = "artificial", .options = [] {
        return optionsOf(viscosityTypes());
    }};
constexpr Key viscosityKey{.name = "viscosity", .leftOut = "by scheme", .entries = [] {
                               return Keys{viscosityType, viscosityWallsKey()};
                           }};

} // namespace

Keys fluidPropertiesKeys()
{
    return fluidPropertiesKeysBeside(viscosityKey);
}

const std::vector<ViscosityType>& viscosityTypes()
{
    static const std::vector<ViscosityType> table = tableOf(ViscosityChoice());
    return table;
}

ViscosityChoice readViscosity(const Dictionary& entries, const TaitEquation& state)
{
    const ViscosityChoice viscosity =
        choose(entries, viscosityType, viscosityTypes(), "viscosity type").read(entries, state);
    entries.refuseUnknown(viscosityKey.entries());
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
                const bool hasUnit = coefficient.key.unit.exponent != unit::none.exponent;
                text += ", " + std::string(coefficient.key.name) + " = " + numberText(type.*coefficient.value, 4) +
                        (hasUnit ? " " + std::string(coefficient.key.unit.name) : "");
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
