// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Token.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>

namespace slosh
{

/// What stands between [ and ]: exponents of [kg m s K mol A cd], and what a value is to be multiplied by.
struct Dimensions
{
    std::array<double, 7> exponent{};
    double factor = 1;
};

/// OpenFOAM's forms: 7 or 5 exponents, "0 1 -2 0 0"; or symbols, "m s^-2", "kg/m^3", "mm": kg m s K mol A Cd, Hz N Pa J
/// W, area volume density acceleration kinematicPressure, cm mm km; ^ and a number, * / and blanks, parentheses.
/// Nothing where it is neither.
std::optional<Dimensions> readDimensions(std::span<const Token> tokens);

/// "[0 1 -2 0 0 0 0]"
std::string dimensionsText(const std::array<double, 7>& exponents);

} // namespace slosh
