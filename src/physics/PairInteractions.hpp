// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "physics/Interactions.hpp"
#include "physics/budgetParts.hpp"
#include "physics/continuity.hpp"
#include "physics/makeInteractions.hpp"
#include "physics/momentum.hpp"
#include "physics/movingLeastSquares.hpp"
#include "physics/walk.hpp"
#include "physics/wallState.hpp"
#include "viscosities/AnyViscosity.hpp"

#include <cmath>
#include <type_traits>
#include <vector>

namespace slosh
{

/// The sums of physics/ for one choice of dimension, kernel and scalar type S: double is the readable reference,
/// Simd<float> and Simd<double> the production loops. In Simd<float> the loops of the right-hand sides are compiled for
/// each viscosity's form and with and without density diffusion, and both rates are summed in one walk with a
/// LineViscosity; elsewhere these are asked for at each pair, and each rate has a walk of its own.
template <int dim, class Kernel, class S>
class PairInteractions final : public Interactions
{
public:
    PairInteractions(const PairGeometry& geometry, const PairTerms& terms)
        : h_(geometry.smoothingLength), terms_(terms), directions_(geometry.directions),
          records_(dim, geometry.directions, h_, Kernel::supportRatio * h_)
    {
    }

    int lanes() const override { return lanesOf<S>; }

    std::string description() const override
    {
        const std::string real = sizeof(RealOf<S>) == 4 ? "float" : "double";
        const auto nameOf = [](const auto& choice)
        { return std::visit([](const auto& term) { return std::string(term.name); }, choice); };
        return std::to_string(dim) + "D, kernel " + std::string(Kernel::name) + ", viscosity " +
               nameOf(terms_.viscosity) + ", density diffusion " + nameOf(terms_.densityDiffusion) + ", " +
               (lanes() == 1 ? "scalar reference loop in " + real : std::to_string(lanes()) + " lanes of " + real);
    }

    void listBuilt(const Particles& particles, const NeighbourList& neighbours, double margin) override
    {
        records_.enclose(particles, margin);
        packWallPositions(particles, neighbours);
    }

    void
    see(const NeighbourList& neighbours, bool wallsHaveMoved, const BodyForce& bodyForce,
        const TaitEquation& equationOfState, bool suction, Particles& particles,
        std::vector<WallContact>& contact) override
    {
        if (wallsHaveMoved)
        {
            packWallPositions(particles, neighbours);
        }
        parallelFor(
            particles.nFluid,
            [&](std::ptrdiff_t i)
            {
                records_.packPosition(i, particles.r[i]);
                records_.packFlow(i, particles.v[i], particles.p[i], particles.rho[i]);
            }
        );
        const double shareOfW = Kernel::alpha(dim) * std::pow(particles.spacing / h_, dim);
        walkWalls<dim, S>(
            records_, neighbours, [](std::ptrdiff_t) { return WallSums<dim, Kernel, S>{}; },
            [&](std::ptrdiff_t w, const WallSums<dim, Kernel, S>& sums)
            {
                const double W = laneSum(sums.W);
                const LiquidAtWall seen{
                    W, static_cast<double>(laneSum(sums.p)), inSpace(sums.towardsWall), inSpace(sums.v), h_};
                bool mayPull = suction;
                if (!contact.empty())
                {
                    WallContact& what = contact[w - particles.nFluid];
                    what.share = shareOfW * W;
                    what.velocity = W > 0 ? Vec(seen.v / W) : particles.v[w];
                    what.away = W > 0 ? Vec(seen.towardsWall * (-h_ / (particles.rho[w] * W))) : Vec::Zero();
                    mayPull = mayPull || what.enclosed;
                }
                const WallState wall =
                    wallState(seen, particles.v[w], bodyForce.onRestingLiquid(particles.r[w]), mayPull);
                particles.p[w] = wall.p;
                particles.rho[w] = equationOfState.rho(wall.p);
                records_.packFlow(w, wall.velocity, wall.p, particles.rho[w]);
            }
        );
    }

    void rates(
        Wanted wanted, const NeighbourList& neighbours, const Particles& particles, const BodyForce& bodyForce,
        Rates& rates
    ) const override
    {
        const Sum sum{*this, neighbours, particles, bodyForce, rates};
        bool bothAreDone = false;
        forViscosity(
            [&]<class Pi>(const Pi& viscosity)
            {
                if constexpr (specialised && std::is_same_v<Pi, LineViscosity<S>>)
                {
                    if (wanted == Wanted::both)
                    {
                        forDiffusion([&](const auto& diffusion) { sum.both(viscosity, diffusion); });
                        bothAreDone = true;
                        return;
                    }
                }
                if (wanted != Wanted::densityRate)
                {
                    sum.momentum(viscosity);
                }
            }
        );
        if (wanted != Wanted::acceleration && !bothAreDone)
        {
            forDiffusion([&](const auto& diffusion) { sum.continuity(diffusion); });
        }
    }

    void budgetParts(
        bool wallsAlone, const NeighbourList& neighbours, const Particles& particles, std::vector<Vec>& viscous,
        Rates& walls
    ) const override
    {
        using Parts = BudgetParts<dim, AnyViscosity<S>, S>;
        const AnyViscosity<S> Pi(wallsAlone ? ViscosityChoice() : terms_.viscosity, dim, h_);
        const double factor = rateFactor(particles);
        walk<dim, S>(
            records_, particles.nFluid, [](std::ptrdiff_t k) { return k; },
            [&](std::ptrdiff_t a) { return wallsAlone ? neighbours.wallPart(a) : neighbours.row(a); },
            [&](std::ptrdiff_t) {
                return gradientSums<Kernel>(Parts{Pi, terms_.wallsSlip, {}, {}, S(0)});
            },
            [&](std::ptrdiff_t a, const auto& sums)
            {
                const Parts& parts = std::get<0>(sums.sums);
                walls.acceleration[a] = -factor * inSpace(parts.wallGradient);
                walls.densityRate[a] = factor * laneSum(parts.wallDivergence) * particles.rho[a];
                if (!wallsAlone && !viscous.empty())
                {
                    viscous[a] = -factor * inSpace(parts.viscous);
                }
            }
        );
    }

    void movingLeastSquares(const NeighbourList& neighbours, const Particles& particles, std::vector<double>& rho)
        const override
    {
        using Sums = MovingLeastSquares<dim, Kernel, S>;
        const double factor = particles.mass * Kernel::alpha(dim) / std::pow(h_, dim);
        walkLiquid<dim, S>(
            records_, neighbours, particles.nFluid, [](std::ptrdiff_t) { return Sums{}; },
            [&](std::ptrdiff_t a, const Sums& sums) { rho[a] = sums.density(factor, rho[a]); }
        );
    }

    std::size_t bytes() const override { return records_.bytes(); }

    /// What the sums are of.
    PairRecords<RealOf<S>>& records() { return records_; }

private:
    /// Where the loops are compiled for each choice.
    static constexpr bool specialised = sizeof(RealOf<S>) == 4 && lanesOf<S> > 1;

    void packWallPositions(const Particles& particles, const NeighbourList& neighbours)
    {
        for (const int w : neighbours.wallsInReach())
        {
            records_.packPosition(w, particles.r[w]);
        }
    }

    /// f(Pi): of its own type where loops are specialised.
    template <class F>
    void forViscosity(const F& f) const
    {
        if constexpr (specialised)
        {
            std::visit([&](const auto& viscosity) { f(viscosity.template inLoop<S>(dim, h_)); }, terms_.viscosity);
        }
        else
        {
            f(AnyViscosity<S>(terms_.viscosity, dim, h_));
        }
    }

    /// f(density diffusion): elsewhere none is Fourtakas' with delta = 0.
    template <class F>
    void forDiffusion(const F& f) const
    {
        if constexpr (specialised)
        {
            std::visit(f, terms_.densityDiffusion);
        }
        else
        {
            const auto* diffusion = std::get_if<FourtakasDensityDiffusion>(&terms_.densityDiffusion);
            f(diffusion != nullptr ? *diffusion : FourtakasDensityDiffusion{});
        }
    }

    double rateFactor(const Particles& particles) const
    {
        return particles.mass * Kernel::alpha(dim) / std::pow(h_, dim + 1);
    }

    Vec inSpace(const std::array<S, dim>& sums) const
    {
        Vec x = Vec::Zero();
        for (std::size_t d = 0; d < dim; ++d)
        {
            x[directions_[d]] = static_cast<double>(laneSum(sums[d]));
        }
        return x;
    }

    /// The right-hand sides, Cao et al. 2014, Eq. 1, of every liquid particle:
    ///   drho_a/dt = rho_a m sum_b (1/rho_b) (v_a - v_b) . grad_a W_ab + D_a - <D_a>
    ///   dv_a/dt   = b_a - m sum_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) grad_a W_ab
    /// grad_a W_ab = alpha/h^(dim+1) F_ab r_ab/h: the factor in front is applied once per particle. b: the body force
    /// (gravity and the frame's), without its component in the empty direction.
    struct Sum
    {
        const PairInteractions& of;
        const NeighbourList& neighbours;
        const Particles& particles;
        const BodyForce& bodyForce;
        Rates& rates;
        double factor = of.rateFactor(particles);
        std::span<const double> meanDiffusion = particles.values<double>(FourtakasDensityDiffusion::meanField);

        template <class Pi>
        auto beginMomentum(const Pi& viscosity) const
        {
            return Momentum<dim, Pi, S>::of(of.terms_, viscosity);
        }
        template <class Diffusion>
        auto beginContinuity(const Diffusion& diffusion, std::ptrdiff_t a) const
        {
            const auto s_a = static_cast<double>(of.records_.of(a)[slotS]);
            const auto D = diffusion.template around<dim, S>(of.directions_, of.h_, bodyForce, particles.r[a], s_a);
            return Continuity<dim, std::decay_t<decltype(D)>, S>{D, S(0), S(0)};
        }
        template <class Pi>
        void finish(std::ptrdiff_t a, const Momentum<dim, Pi, S>& sums) const
        {
            const Vec b = bodyForce.onLiquid(particles.r[a], particles.v[a]);
            rates.acceleration[a].setZero();
            for (std::size_t d = 0; d < dim; ++d)
            {
                const int k = of.directions_[d];
                rates.acceleration[a][k] = b[k] - factor * laneSum(sums.gradient[d]);
            }
        }
        template <class D>
        void finish(std::ptrdiff_t a, const Continuity<dim, D, S>& sums) const
        {
            rates.densityRate[a] = factor * laneSum(sums.divergence) * particles.rho[a];
            if constexpr (Continuity<dim, D, S>::diffuses)
            {
                rates.diffusion[a] = factor * laneSum(sums.diffusion) * particles.rho[a];
                rates.densityRate[a] += rates.diffusion[a] - (meanDiffusion.empty() ? 0 : meanDiffusion[a]);
            }
        }

        template <class Pi>
        void momentum(const Pi& viscosity) const
        {
            walkLiquid<dim, S>(
                of.records_, neighbours, particles.nFluid,
                [&](std::ptrdiff_t) { return gradientSums<Kernel>(beginMomentum(viscosity)); },
                [&](std::ptrdiff_t a, const auto& sums) { finish(a, std::get<0>(sums.sums)); }
            );
        }
        template <class Diffusion>
        void continuity(const Diffusion& diffusion) const
        {
            walkLiquid<dim, S>(
                of.records_, neighbours, particles.nFluid,
                [&](std::ptrdiff_t a) { return gradientSums<Kernel>(beginContinuity(diffusion, a)); },
                [&](std::ptrdiff_t a, const auto& sums) { finish(a, std::get<0>(sums.sums)); }
            );
        }
        /// Both in one walk.
        template <class Pi, class Diffusion>
        void both(const Pi& viscosity, const Diffusion& diffusion) const
        {
            walkLiquid<dim, S>(
                of.records_, neighbours, particles.nFluid,
                [&](std::ptrdiff_t a)
                { return gradientSums<Kernel>(beginMomentum(viscosity), beginContinuity(diffusion, a)); },
                [&](std::ptrdiff_t a, const auto& sums)
                {
                    finish(a, std::get<1>(sums.sums));
                    finish(a, std::get<0>(sums.sums));
                }
            );
        }
    };

    double h_;
    PairTerms terms_;
    std::array<int, 3> directions_;
    PairRecords<RealOf<S>> records_;
};

} // namespace slosh
