// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"

namespace slosh
{

/// CPU seconds of a run with the spacing dx below that of the finest run, t = t_finest (dx_finest/dx)^(d + 1): the
/// particles are as many as dx^-d, d = 1, 2 or 3 by those of the coarsest and the finest run, the steps as 1/dx. Short
/// runs, most of which is starting, show less; a power fitted to them promises too much. NaN where the runs do not
/// show d.
double costOfFinerSpacing(const Row& coarsest, const Row& finest, double dx);

} // namespace slosh
