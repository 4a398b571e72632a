#include "integration/PredictorCorrector.hpp"

#include "base/parallel.hpp"

#include <algorithm>

namespace slosh
{

void PredictorCorrector::predict(Particles& particles, const Rates& rates, double dt)
{
    const auto n = particles.nFluid;
    r_.assign(particles.r.begin(), particles.r.begin() + n);
    v_.assign(particles.v.begin(), particles.v.begin() + n);
    rho_.assign(particles.rho.begin(), particles.rho.begin() + n);
    parallelFor(n,
                [&](std::ptrdiff_t k)
                {
                    const auto i = static_cast<std::size_t>(k);
                    particles.r[i] += dt / 2 * v_[i];
                    particles.v[i] += dt / 2 * rates.acceleration[i];
                    particles.rho[i] += dt / 2 * rates.densityRate[i];
                });
}

void PredictorCorrector::correct(Particles& particles, const Rates& rates, double dt) const
{
    parallelFor(particles.nFluid,
                [&](std::ptrdiff_t k)
                {
                    const auto i = static_cast<std::size_t>(k);
                    particles.v[i] = v_[i] + dt * rates.acceleration[i];
                    particles.rho[i] = rho_[i] + dt * rates.densityRate[i];
                    particles.r[i] = r_[i] + dt / 2 * (v_[i] + particles.v[i]);
                });
}

void PredictorCorrector::restore(Particles& particles) const
{
    std::copy(r_.begin(), r_.end(), particles.r.begin());
    std::copy(v_.begin(), v_.end(), particles.v.begin());
    std::copy(rho_.begin(), rho_.end(), particles.rho.begin());
}

std::size_t PredictorCorrector::bytes() const
{
    return (r_.capacity() + v_.capacity()) * sizeof(Vec) + rho_.capacity() * sizeof(double);
}

} // namespace slosh
