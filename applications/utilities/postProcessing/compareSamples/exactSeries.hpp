// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "statistics/TimeSeries.hpp"

namespace slosh
{

// Exact solutions at the times of `samples`; the keys of each stand in Reference.hpp. They read what they need of the
// case: tank, gravity, density, motion. Throw CaseError.

/// Surface elevation above the still level, [m], or pressure, [Pa], at `location` in the tank, to first order in the
/// motion: a 2D tank filled from wall to wall without bodies, or a 3D one that sways.
TimeSeries linearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

/// Surface elevation as above of nonlinear potential flow: a 2D tank that sways.
TimeSeries nonlinearSloshing(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

/// Surface elevation of the standing wave `mode` of a liquid of viscosity `nu` between walls along which it slips, set
/// in motion with `velocity` at the lower wall from its flat state, [m]: a 2D tank at rest without bodies.
TimeSeries viscousStandingWave(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

/// Semi-axes or central pressure of the patch v = (-A0 x, A0 z).
TimeSeries stretchingPatch(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

/// The same of the drop v = (-A0 x/2, -A0 y/2, A0 z).
TimeSeries stretchingDrop(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

} // namespace slosh
