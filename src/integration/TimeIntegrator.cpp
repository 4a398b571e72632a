#include "integration/TimeIntegrator.hpp"

#include "integration/PositionVerlet.hpp"
#include "integration/PredictorCorrector.hpp"

#include <algorithm>

namespace slosh
{

std::vector<std::string> TimeIntegrator::names()
{
    return {"predictorCorrector", "positionVerlet"};
}

std::unique_ptr<TimeIntegrator> TimeIntegrator::make(const std::string& name)
{
    if (name == "positionVerlet")
    {
        return std::make_unique<PositionVerlet>();
    }
    return std::make_unique<PredictorCorrector>();
}

void TimeIntegrator::keep(const Particles& particles)
{
    const auto n = particles.nFluid;
    r_.assign(particles.r.begin(), particles.r.begin() + n);
    v_.assign(particles.v.begin(), particles.v.begin() + n);
    rho_.assign(particles.rho.begin(), particles.rho.begin() + n);
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
