// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"

namespace slosh
{

/// An entry whose number goes to a T.
template <class T>
struct Coefficient
{
    Key key;
    double T::*value;
};

} // namespace slosh
