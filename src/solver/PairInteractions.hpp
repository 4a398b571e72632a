// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "physics/movingLeastSquares.hpp"
#include "physics/pairRates.hpp"
#include "physics/wallPressure.hpp"
#include "solver/Interactions.hpp"
#include "solver/makeInteractions.hpp"

#include <vector>

namespace slosh
{

/// The sums of physics/ for one choice of dimension, kernel, viscosity, density diffusion and scalar type S: double is
/// the readable reference, Simd<float> and Simd<double> the production loops.
template <int dim, class Kernel, class Viscosity, class DensityDiffusion, class S>
class PairInteractions final : public Interactions
{
public:
    PairInteractions(const PairGeometry& geometry, const Viscosity& viscosity, bool wallsSlip,
                     const DensityDiffusion& diffusion)
        : h_(geometry.smoothingLength), viscosity_(viscosity), wallsSlip_(wallsSlip), densityDiffusion_(diffusion),
          records_(dim, geometry.directions, h_, Kernel::supportRatio * h_)
    {
    }

    int lanes() const override { return lanesOf<S>; }

    std::string description() const override
    {
        const std::string real = sizeof(RealOf<S>) == 4 ? "float" : "double";
        return std::to_string(dim) + "D, kernel " + std::string(Kernel::name) + ", viscosity " +
               std::string(Viscosity::name) + ", density diffusion " + std::string(DensityDiffusion::name) + ", " +
               (lanes() == 1 ? "scalar reference loop in " + real : std::to_string(lanes()) + " lanes of " + real);
    }

    void listBuilt(const Particles& particles, const NeighbourList& neighbours, double margin) override
    {
        records_.enclose(particles, margin);
        packWallPositions(particles, neighbours);
    }

    void packLiquid(const Particles& particles) override
    {
        parallelFor(particles.nFluid,
                    [&](std::ptrdiff_t i)
                    {
                        records_.packPosition(i, particles.r[i]);
                        records_.packFlow(i, particles.v[i], particles.p[i], particles.rho[i]);
                    });
    }

    void packWallPositions(const Particles& particles, const NeighbourList& neighbours) override
    {
        for (const int w : neighbours.wallsInReach())
        {
            records_.packPosition(w, particles.r[w]);
        }
    }

    void packWallFlow(const Particles& particles, const NeighbourList& neighbours) override
    {
        const auto& walls = neighbours.wallsInReach();
        parallelFor(static_cast<std::ptrdiff_t>(walls.size()),
                    [&](std::ptrdiff_t k)
                    {
                        const int i = walls[k];
                        records_.packFlow(i, shown_[i], particles.p[i], particles.rho[i]);
                    });
    }

    void wallPressure(const NeighbourList& neighbours, const BodyForce& bodyForce, bool suction, Particles& particles,
                      std::vector<WallContact>& contact) override
    {
        shown_.resize(particles.r.size());
        slosh::wallPressure<dim, Kernel, S>(records_, neighbours, bodyForce, h_, suction, particles, shown_, contact);
    }

    void rates(Wanted wanted, const NeighbourList& neighbours, const Particles& particles, const BodyForce& bodyForce,
               Rates& rates) const override
    {
        const auto sum = [&]<Wanted which>(std::integral_constant<Wanted, which>)
        {
            pairRates<dim, Kernel, S, which>(records_, neighbours, particles, h_, bodyForce, viscosity_, wallsSlip_,
                                             densityDiffusion_, rates);
        };
        switch (wanted)
        {
        case Wanted::both:
            return sum(std::integral_constant<Wanted, Wanted::both>());
        case Wanted::acceleration:
            return sum(std::integral_constant<Wanted, Wanted::acceleration>());
        case Wanted::densityRate:
            return sum(std::integral_constant<Wanted, Wanted::densityRate>());
        case Wanted::dissipation:
            return sum(std::integral_constant<Wanted, Wanted::dissipation>());
        case Wanted::walls: // the same loop for all viscosities and diffusions: compiled once
            return pairRates<dim, Kernel, S, Wanted::walls>(records_, neighbours, particles, h_, bodyForce,
                                                            NoViscosity{}, wallsSlip_, NoDensityDiffusion{}, rates);
        }
    }

    void movingLeastSquares(const NeighbourList& neighbours, const Particles& particles,
                            std::vector<double>& rho) const override
    {
        slosh::movingLeastSquares<dim, Kernel, S>(records_, neighbours, particles.nFluid, particles.mass, h_, rho);
    }

    std::size_t bytes() const override { return records_.bytes() + shown_.capacity() * sizeof(Vec); }

private:
    double h_;
    Viscosity viscosity_;
    bool wallsSlip_;
    DensityDiffusion densityDiffusion_;
    PairRecords<RealOf<S>> records_;
    std::vector<Vec> shown_; ///< the velocity that walls show, by particle
};

/// The alternatives of terms, dimension and precision for one kernel: each kernel's source instantiates it once, so
/// that the kernels are compiled in parallel.
template <class Kernel>
std::unique_ptr<Interactions> makeForKernel(const PairGeometry& geometry, const PairTerms& terms, Precision precision)
{
    return std::visit(
        [&](const auto& viscosity, const auto& diffusion) -> std::unique_ptr<Interactions>
        {
            using Viscosity = std::decay_t<decltype(viscosity)>;
            using Diffusion = std::decay_t<decltype(diffusion)>;
            const auto inDimension = [&]<int dim>(std::integral_constant<int, dim>) -> std::unique_ptr<Interactions>
            {
                const auto make = [&]<class S>(std::type_identity<S>) -> std::unique_ptr<Interactions>
                {
                    return std::make_unique<PairInteractions<dim, Kernel, Viscosity, Diffusion, S>>(
                        geometry, viscosity, terms.wallsSlip, diffusion);
                };
                switch (precision)
                {
                case Precision::reference:
                    return make(std::type_identity<double>());
                case Precision::doublePrecision:
                    return make(std::type_identity<Simd<double>>());
                default:
                    return make(std::type_identity<Simd<float>>());
                }
            };
            return geometry.dim == 2 ? inDimension(std::integral_constant<int, 2>())
                                     : inDimension(std::integral_constant<int, 3>());
        },
        terms.viscosity, terms.densityDiffusion);
}

} // namespace slosh
