// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Sweep.hpp"

namespace slosh
{

/// A script for sbatch: an array of one task a case, each this program with -only, `atOnce` of them at a time at
/// most (0: as many as there is room for). `dictName`: the dictionary of the sweep.
std::string
slurmScript(const Sweep& sweep, const std::filesystem::path& caseRoot, const std::string& dictName, long atOnce);

} // namespace slosh
