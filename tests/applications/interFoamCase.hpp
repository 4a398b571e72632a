// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseDirectory.hpp"

#include <string>

namespace slosh
{

/// Where Debian's package openfoam-examples has interFoam's laminar cases.
std::filesystem::path interFoamCases();

/// What is missing of openfoam, openfoam-examples and m4 for tests on those cases, in words; empty: nothing.
std::string missingForInterFoamCases();

/// A copy of one of them, its mesh description expanded by m4 as its own Allrun does.
class InterFoamCase : public CaseDirectory
{
public:
    explicit InterFoamCase(const std::string& name);
};

} // namespace slosh
