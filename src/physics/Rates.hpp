// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <cstddef>
#include <vector>

namespace slosh
{

/// Which right-hand sides are summed: integrators that stagger them ask for one at a time.
enum class Wanted
{
    both,
    acceleration,
    densityRate
};

/// Right-hand sides of the liquid particles, Cao et al. 2014, Eq. 1.
struct Rates
{
    std::vector<Vec> acceleration;   ///< dv/dt, [m/s^2]
    std::vector<double> densityRate; ///< drho/dt, [kg/m^3/s]
    std::vector<double> diffusion;   ///< of that, by density diffusion, its mean not taken away

    std::size_t bytes() const
    {
        return acceleration.capacity() * sizeof(Vec) + (densityRate.capacity() + diffusion.capacity()) * sizeof(double);
    }
    void resize(std::ptrdiff_t nFluid)
    {
        acceleration.resize(nFluid, Vec::Zero());
        densityRate.resize(nFluid, 0.0);
        diffusion.resize(nFluid, 0.0);
    }
};

} // namespace slosh
