// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Choice.hpp"
#include "particles/Particles.hpp"
#include "scene/Scene.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// A field that is computed from the others where it is asked for: one line a field in the table of derivedField.cpp.
using DerivedField = Choice<Field (*)(const Particles& particles, const Scene& scene)>;

const std::vector<DerivedField>& derivedFields();

/// The one called `name`. Throws CaseError where there is none, naming the nearest of these and of `others`.
Field derivedField(
    const std::string& name, const Particles& particles, const Scene& scene, const std::vector<std::string>& others
);

} // namespace slosh
