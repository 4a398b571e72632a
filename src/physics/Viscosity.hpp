#pragma once

#include "physics/ArtificialViscosity.hpp"
#include "physics/NoViscosity.hpp"

#include <variant>

namespace slosh
{

/// What adds to the pressure of a pair; each is a type with `name` and inLoop<S>(): (pair, approach) -> Pi_ab.
using ViscosityChoice = std::variant<NoViscosity, ArtificialViscosity>;

} // namespace slosh
