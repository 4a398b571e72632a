// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace slosh
{

/// The unit a value is read in: exponents of [kg m s K mol A cd], as OpenFOAM writes dimensions, and its name in
/// messages.
struct Unit
{
    std::array<double, 7> exponent{};
    std::string_view name;
};

namespace unit
{
inline constexpr Unit none{{}, "dimensionless"};
inline constexpr Unit metre{{0, 1}, "m"};
inline constexpr Unit squareMetre{{0, 2}, "m^2"};
inline constexpr Unit cubicMetre{{0, 3}, "m^3"};
inline constexpr Unit second{{0, 0, 1}, "s"};
inline constexpr Unit perSecond{{0, 0, -1}, "1/s"};
inline constexpr Unit kilogram{{1}, "kg"};
inline constexpr Unit density{{1, -3}, "kg/m^3"};
inline constexpr Unit velocity{{0, 1, -1}, "m/s"};
inline constexpr Unit acceleration{{0, 1, -2}, "m/s^2"};
inline constexpr Unit pressure{{1, -1, -2}, "Pa"};
inline constexpr Unit kinematicViscosity{{0, 2, -1}, "m^2/s"};
// OpenFOAM's angles carry no dimensions; the name tells which one is meant.
inline constexpr Unit degree{{}, "deg"};
inline constexpr Unit radianPerSecond{{0, 0, -1}, "rad/s"};
} // namespace unit

} // namespace slosh
