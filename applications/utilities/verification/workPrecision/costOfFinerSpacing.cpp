// SPDX-License-Identifier: GPL-3.0-or-later
#include "costOfFinerSpacing.hpp"

#include <cmath>

namespace slosh
{

double costOfFinerSpacing(const Row& coarsest, const Row& finest, double dx)
{
    const Outcome &few = coarsest.run->outcome, &many = finest.run->outcome;
    const double dimensions = std::round(
        std::log(static_cast<double>(many.particles) / static_cast<double>(few.particles)) /
        std::log(coarsest.spacing / finest.spacing)
    );
    constexpr double most = 3;
    return dimensions >= 1 && dimensions <= most && many.cpuSeconds > 0
               ? many.cpuSeconds * std::pow(finest.spacing / dx, dimensions + 1)
               : Outcome::unknown;
}

} // namespace slosh
