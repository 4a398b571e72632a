// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/ArtificialViscosity.hpp"
#include "physics/LaminarViscosity.hpp"
#include "physics/LowDissipationRiemann.hpp"
#include "physics/NoViscosity.hpp"

#include <variant>

namespace slosh
{

/// What adds to the pressure of a pair; each is a type with `name` and inLoop<S>(dim): (pair, approach) -> Pi_ab.
using ViscosityChoice = std::variant<NoViscosity, ArtificialViscosity, LaminarViscosity, LowDissipationRiemann>;

} // namespace slosh
