// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/PairInteractions.hpp"

namespace slosh
{

template std::unique_ptr<Interactions> makeForKernel<CubicSpline>(const PairGeometry&, const PairTerms&, Precision);

} // namespace slosh
