// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

namespace slosh
{

/// What a wall particle sees of the liquid, by the sums of physics/wallState.hpp.
struct WallContact
{
    double share = 0; ///< sum_f V W_wf, V = m/rho0: about a quarter in the first row beside liquid, 0 where dry
    Vec velocity = Vec::Zero(); ///< sum_f v_f W_wf / sum_f W_wf, in the solver's frame, [m/s]
    Vec away = Vec::Zero();     ///< sum_f (r_f - r_w) W_wf / sum_f W_wf: how far away it sees that, [m]
    /// No air comes to it, as the liquid around is deep (physics/AcousticDamper.hpp): it may pull.
    bool enclosed = false;
};

} // namespace slosh
