// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Unit.hpp"

#include <string_view>

namespace slosh
{

/// A number >= 0 that a dictionary gives to a T, as data.
template <class T>
struct Coefficient
{
    std::string_view key;
    double T::*value;
    Unit unit;
};

} // namespace slosh
