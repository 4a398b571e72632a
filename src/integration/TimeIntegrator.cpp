// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/TimeIntegrator.hpp"

#include "base/parallel.hpp"

#include <algorithm>

namespace slosh
{

void TimeIntegrator::halfStep(Particles& particles, const Rates& rates, double dt)
{
    const std::ptrdiff_t n = particles.nFluid;
    r_.resize(n);
    v_.resize(n);
    rho_.resize(n);
    parallelFor(
        particles.nFluid,
        [&](std::ptrdiff_t i)
        {
            r_[i] = particles.r[i];
            v_[i] = particles.v[i];
            rho_[i] = particles.rho[i];
            particles.r[i] += dt / 2 * v_[i];
            particles.v[i] += dt / 2 * rates.acceleration[i];
            particles.rho[i] += dt / 2 * rates.densityRate[i];
        }
    );
}

void TimeIntegrator::restore(Particles& particles) const
{
    std::copy(r_.begin(), r_.end(), particles.r.begin());
    std::copy(v_.begin(), v_.end(), particles.v.begin());
    std::copy(rho_.begin(), rho_.end(), particles.rho.begin());
}

std::size_t TimeIntegrator::bytes() const
{
    return (r_.capacity() + v_.capacity()) * sizeof(Vec) + rho_.capacity() * sizeof(double);
}

} // namespace slosh
