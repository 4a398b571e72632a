// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BlockMesh.hpp"
#include "ExtrudedTank.hpp"
#include "Turn.hpp"

#include "case/Case.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// What their functions are converted for.
struct FunctionSite
{
    const BlockMesh& mesh;    ///< theirs
    const ExtrudedTank& tank; ///< ours
    const Turn& turn;
    bool moves;    ///< the tank
    double deltaT; ///< of their controlDict, [s]
};

/// What samples in system/controlDict and system/functions (OpenFOAM 12 and later) as ours does: probes of p and wave
/// gauges (interfaceHeight), their points inside the tank and turned; forces on all walls. Whether and when a function
/// runs goes with it (enabled, timeStart, timeEnd); `timeStep` becomes runTime, by their deltaT: ours is far shorter.
/// `warnings` says what is omitted, also functions that cannot be read.
Dictionary convertFunctions(
    const Case& from, const Dictionary& controlDict, const FunctionSite& site, std::vector<std::string>& warnings
);

} // namespace slosh
