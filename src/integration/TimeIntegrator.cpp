// SPDX-License-Identifier: GPL-3.0-or-later
#include "integration/TimeIntegrator.hpp"

#include "base/parallel.hpp"
#include "particles/numbersOf.hpp"

#include <algorithm>

namespace slosh
{

void TimeIntegrator::halfStep(Particles& particles, const Rates& rates, double dt)
{
    const std::ptrdiff_t n = particles.nFluid;
    r_.resize(n);
    v_.resize(n);
    rho_.resize(n);
    parallelBlocks(
        n, particlesPerBlock,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            const auto of = [=](auto& field) { return numbersOf(field, begin, end); };
            of(r_) = of(particles.r);
            of(v_) = of(particles.v);
            of(rho_) = of(particles.rho);
            of(particles.r) += dt / 2 * of(v_);
            of(particles.v) += dt / 2 * of(rates.acceleration);
            of(particles.rho) += dt / 2 * of(rates.densityRate);
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
