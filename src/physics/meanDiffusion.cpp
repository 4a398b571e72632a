// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/meanDiffusion.hpp"

#include "base/parallel.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

void advanceMeanDiffusion(
    Particles& particles, const Rates& rates, double smoothingLength, double c0, double sinceStart, double dt
)
{
    const auto means = particles.values<double>(FourtakasDensityDiffusion::meanField);
    const double T = FourtakasDensityDiffusion::memory(smoothingLength, c0);
    const double share = -std::expm1(-dt / std::clamp(sinceStart, T / 10, T));
    parallelFor(
        static_cast<std::ptrdiff_t>(means.size()),
        [&](std::ptrdiff_t i)
        {
            // No liquid in reach: nothing to exchange volume with.
            means[i] = rates.diffusion[i] == 0 ? 0 : means[i] + share * (rates.diffusion[i] - means[i]);
        }
    );
}

} // namespace slosh
