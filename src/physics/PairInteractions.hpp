// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Interactions.hpp"
#include "physics/PairSums.hpp"
#include "physics/budgetParts.hpp"
#include "physics/continuity.hpp"
#include "physics/makeInteractions.hpp"
#include "physics/momentum.hpp"
#include "physics/movingLeastSquares.hpp"
#include "physics/wallState.hpp"
#include "viscosities/AnyViscosity.hpp"

#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

namespace slosh
{

/// The sums of physics/ for one choice of dimension, kernel and scalar type S: double is the readable reference,
/// SimdOfRows<float> and SimdOfRows<double> the production loops. In single precision the loops of the right-hand sides
/// are compiled for each viscosity's form and with and without density diffusion, and both rates are summed in one walk
/// with a LineViscosity; elsewhere these are asked for at each pair, and both rates are always summed in one walk.
template <int dim, class Kernel, class S>
class PairInteractions final : public Interactions
{
    using Real = RealOf<S>;
    using Points = std::array<std::ptrdiff_t, rowsOf<S>>; ///< liquid particles that are summed for at a time

public:
    PairInteractions(const PairGeometry& geometry, const PairTerms& terms)
        : h_(geometry.smoothingLength), terms_(terms), directions_(geometry.directions),
          sums_(geometry.directions, h_, Kernel::supportRatio * h_)
    {
    }

    std::string description() const override
    {
        const std::string real = sizeof(Real) == 4 ? "float" : "double";
        const auto nameOf = [](const auto& choice)
        { return std::visit([](const auto& term) { return std::string(term.name); }, choice); };
        return std::to_string(dim) + "D, kernel " + std::string(Kernel::name) + ", viscosity " +
               nameOf(terms_.viscosity) + ", density diffusion " + nameOf(terms_.densityDiffusion) + ", " +
               (lanesOf<S> == 1 ? "scalar reference loop in " + real
                                : std::to_string(lanesOf<S> / rowsOf<S>) + " lanes of " + real);
    }

    void listBuilt(const Particles& particles, const ClusterLists& lists, double margin) override
    {
        sums_.listBuilt(particles, lists, margin);
    }

    void wallsMoved(const Particles& particles, const ClusterLists& lists) override
    {
        sums_.records().packWallPositions(particles, lists);
    }

    void
    see(const ClusterLists& lists, const WallConditions& conditions, const SetPressure& setPressure,
        Particles& particles, std::vector<WallContact>& contact) override
    {
        using Sums = WallSums<dim, Kernel, S>;
        sums_.ofWalls(
            particles, lists,
            [&](std::ptrdiff_t begin, std::ptrdiff_t end)
            {
                if (setPressure)
                {
                    setPressure(begin, end);
                }
            },
            [](const Points&) { return Sums{}; },
            [&](std::ptrdiff_t cluster, const ClusterSums<Sums::numbers>& sums)
            { showWalls(lists.walls(), cluster, sums, conditions, particles, contact); }
        );
    }

    void rates(
        Wanted wanted, const ClusterLists& lists, const Particles& particles, const BodyForce& bodyForce, Rates& rates
    ) const override
    {
        const RightHandSides sum{*this, lists, particles, bodyForce, rates};
        if constexpr (!specialised)
        {
            forDiffusion([&](const auto& diffusion)
                         { sum.both(wanted, AnyViscosity<S>(terms_.viscosity, dim, h_), diffusion); });
        }
        else
        {
            forViscosity(
                [&]<class Pi>(const Pi& viscosity)
                {
                    using Line = LineViscosity<S>;
                    // A line of nothing costs less than a second walk.
                    constexpr bool inOneWalk = std::is_same_v<Pi, Line> || std::is_same_v<Pi, NoViscosity::InLoop<S>>;
                    if (inOneWalk && wanted == Wanted::both)
                    {
                        Line line{};
                        if constexpr (std::is_same_v<Pi, Line>)
                        {
                            line = viscosity;
                        }
                        forDiffusion([&](const auto& diffusion) { sum.both(wanted, line, diffusion); });
                        return;
                    }
                    if (wanted != Wanted::densityRate)
                    {
                        sum.momentum(viscosity);
                    }
                    if (wanted != Wanted::acceleration)
                    {
                        forDiffusion([&](const auto& diffusion) { sum.continuity(diffusion); });
                    }
                }
            );
        }
    }

    void budgetParts(
        bool wallsAlone, const ClusterLists& lists, const Particles& particles, std::vector<Vec>& viscous, Rates& walls
    ) const override
    {
        using Parts = BudgetParts<dim, AnyViscosity<S>, S>;
        const AnyViscosity<S> Pi(wallsAlone ? ViscosityChoice() : terms_.viscosity, dim, h_);
        const double factor = rateFactor(particles);
        sums_.ofLiquid(
            lists, wallsAlone,
            [&](const Points&) {
                return gradientSums<Kernel>(Parts{Pi, terms_.wallsSlip});
            },
            [&](std::ptrdiff_t a, const std::array<double, Parts::numbers>& sums)
            {
                walls.acceleration[a] = -factor * inSpace(&sums[Parts::wallGradient]);
                walls.densityRate[a] = factor * sums[Parts::wallDivergence] * particles.rho[a];
                if (!wallsAlone && !viscous.empty())
                {
                    viscous[a] = -factor * inSpace(&sums[Parts::viscous]);
                }
            }
        );
    }

    void
    movingLeastSquares(const ClusterLists& lists, const Particles& particles, std::vector<double>& rho) const override
    {
        using Sums = MovingLeastSquares<dim, Kernel, S>;
        const double factor = particles.mass * Kernel::alpha(dim) / std::pow(h_, dim);
        sums_.ofLiquid(
            lists, false, [](const Points&) { return Sums{}; },
            [&](std::ptrdiff_t a, const std::array<double, Sums::numbers>& sums)
            { rho[a] = Sums::density(factor, sums); }
        );
    }

    std::size_t bytes() const override { return sums_.bytes(); }

    /// What the sums are of.
    ClusterRecords<dim, Real>& records() { return sums_.records(); }

private:
    /// Where the loops are compiled for each choice.
    static constexpr bool specialised = sizeof(Real) == 4 && lanesOf<S> > 1;

    /// f(Pi), the loop's form of the viscosity.
    template <class F>
    void forViscosity(const F& f) const
    {
        std::visit([&](const auto& viscosity) { f(viscosity.template inLoop<S>(dim, h_)); }, terms_.viscosity);
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

    /// Gives a cluster of walls the state that its sums make.
    void showWalls(
        const Clusters& walls, std::ptrdiff_t cluster, const ClusterSums<WallSums<dim, Kernel, S>::numbers>& sums,
        const WallConditions& conditions, Particles& particles, std::vector<WallContact>& contact
    )
    {
        using Sums = WallSums<dim, Kernel, S>;
        using D = std::conditional_t<lanesOf<S> == 1, double, Simd<double>>;
        const int first = walls.firstPlace(cluster), size = walls.pointsIn(cluster);
        const double dx = particles.spacing / h_, shareOfW = Kernel::alpha(dim) * dx * dx * (dim == 3 ? dx : 1);
        std::array<OfCluster<double>, dim> v{}, b{};
        OfCluster<double> mayPull{}, p{}, rho{};
        for (int lane = 0; lane < size; ++lane)
        {
            const std::ptrdiff_t wall = walls.point(first + lane), w = particles.nFluid + wall;
            const Vec force = conditions.bodyForce.onRestingLiquid(particles.r[w]);
            for (std::size_t d = 0; d < dim; ++d)
            {
                v[d][lane] = particles.v[w][directions_[d]];
                b[d][lane] = force[directions_[d]];
            }
            mayPull[lane] = conditions.suction || (!contact.empty() && contact[wall].enclosed) ? 1 : 0;
        }
        for (int lane = 0; lane < clusterSize; lane += lanesOf<D>)
        {
            const auto from = [lane](const OfCluster<double>& of) { return load<D>(&of[lane]); };
            LiquidAtWall<dim, D> seen{from(sums[Sums::W]), from(sums[Sums::p]), {}, {}, h_};
            std::array<D, dim> ofWall, force;
            unrolled<dim>(
                [&](auto d)
                {
                    seen.towardsWall[d] = from(sums[Sums::towardsWall + d]);
                    seen.v[d] = from(sums[Sums::v + d]);
                    ofWall[d] = from(v[d]);
                    force[d] = from(b[d]);
                }
            );
            const WallState<dim, D> state = wallState(seen, ofWall, force, from(mayPull));
            store(state.p, &p[lane]);
            store(conditions.equationOfState.rho(state.p), &rho[lane]);
            unrolled<dim>([&](auto d) { store(state.velocity[d], &v[d][lane]); });
        }
        sums_.records().packWalls(cluster, v, p, rho);
        for (int lane = 0; lane < size; ++lane)
        {
            const std::ptrdiff_t wall = walls.point(first + lane), w = particles.nFluid + wall;
            if (!contact.empty())
            {
                const double W = sums[Sums::W][lane], perW = W > 0 ? 1 / W : 0;
                WallContact& what = contact[wall];
                what.share = shareOfW * W;
                what.velocity = particles.v[w];
                what.away.setZero();
                for (std::size_t d = 0; W > 0 && d < dim; ++d)
                {
                    what.velocity[directions_[d]] = sums[Sums::v + d][lane] * perW;
                    what.away[directions_[d]] = sums[Sums::towardsWall + d][lane] * perW * -h_ / particles.rho[w];
                }
            }
            particles.p[w] = p[lane];
            particles.rho[w] = rho[lane];
        }
    }

    double rateFactor(const Particles& particles) const
    {
        return particles.mass * Kernel::alpha(dim) / std::pow(h_, dim + 1);
    }

    /// The first dim of `sums` along the scene's directions.
    Vec inSpace(const double* sums) const
    {
        Vec x = Vec::Zero();
        for (std::size_t d = 0; d < dim; ++d)
        {
            x[directions_[d]] = sums[d];
        }
        return x;
    }

    /// The right-hand sides, Cao et al. 2014, Eq. 1, of every liquid particle:
    ///   drho_a/dt = rho_a m sum_b (1/rho_b) (v_a - v_b) . grad_a W_ab + D_a - <D_a>
    ///   dv_a/dt   = b_a - m sum_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) grad_a W_ab
    /// grad_a W_ab = alpha/h^(dim+1) F_ab r_ab/h: the factor in front is applied once per particle. b: the body force
    /// (gravity and the frame's), without its component in the empty direction.
    struct RightHandSides
    {
        const PairInteractions& of;
        const ClusterLists& lists;
        const Particles& particles;
        const BodyForce& bodyForce;
        Rates& rates;
        double factor = of.rateFactor(particles);
        std::span<const double> meanDiffusion = particles.values<double>(FourtakasDensityDiffusion::meanField);

        template <class Pi>
        auto momentumOf(const Pi& viscosity) const
        {
            return Momentum<dim, Pi, S>::of(of.terms_, viscosity);
        }
        template <class Diffusion>
        auto continuityOf(const Diffusion& diffusion, const Points& points) const
        {
            std::array<Vec, rowsOf<S>> r;
            std::array<double, rowsOf<S>> rho;
            for (std::size_t row = 0; row < points.size(); ++row)
            {
                r[row] = particles.r[points[row]];
                rho[row] = particles.rho[points[row]];
            }
            const auto D = diffusion.template around<dim, S>(of.directions_, of.h_, bodyForce, r, rho);
            return Continuity<dim, std::decay_t<decltype(D)>, S>{D};
        }
        void finishMomentum(std::ptrdiff_t a, const double* gradient) const
        {
            const Vec b = bodyForce.onLiquid(particles.r[a], particles.v[a]);
            Vec acceleration = Vec::Zero();
            for (std::size_t d = 0; d < dim; ++d)
            {
                const int k = of.directions_[d];
                acceleration[k] = b[k] - factor * gradient[d];
            }
            rates.acceleration[a] = acceleration;
        }
        template <class Continuity>
        void finishContinuity(std::ptrdiff_t a, const double* sums) const
        {
            rates.densityRate[a] = factor * sums[Continuity::divergence] * particles.rho[a];
            if constexpr (Continuity::diffuses)
            {
                rates.diffusion[a] = factor * sums[Continuity::diffusion] * particles.rho[a];
                rates.densityRate[a] += rates.diffusion[a] - (meanDiffusion.empty() ? 0 : meanDiffusion[a]);
            }
        }

        template <class Pi>
        void momentum(const Pi& viscosity) const
        {
            of.sums_.ofLiquid(
                lists, false, [&](const Points&) { return gradientSums<Kernel>(momentumOf(viscosity)); },
                [&](std::ptrdiff_t a, const auto& sums) { finishMomentum(a, sums.data()); }
            );
        }
        template <class Diffusion>
        void continuity(const Diffusion& diffusion) const
        {
            using Term = decltype(continuityOf(diffusion, Points()));
            of.sums_.ofLiquid(
                lists, false, [&](const Points& a) { return gradientSums<Kernel>(continuityOf(diffusion, a)); },
                [&](std::ptrdiff_t a, const auto& sums) { finishContinuity<Term>(a, sums.data()); }
            );
        }
        /// Both in one walk; those that are not wanted are not written.
        template <class Pi, class Diffusion>
        void both(Wanted wanted, const Pi& viscosity, const Diffusion& diffusion) const
        {
            using Term = decltype(continuityOf(diffusion, Points()));
            of.sums_.ofLiquid(
                lists, false,
                [&](const Points& a)
                { return gradientSums<Kernel>(momentumOf(viscosity), continuityOf(diffusion, a)); },
                [&, wanted](std::ptrdiff_t a, const auto& sums)
                {
                    if (wanted != Wanted::acceleration)
                    {
                        finishContinuity<Term>(a, sums.data() + dim);
                    }
                    if (wanted != Wanted::densityRate)
                    {
                        finishMomentum(a, sums.data());
                    }
                }
            );
        }
    };

    double h_;
    PairTerms terms_;
    std::array<int, 3> directions_;
    PairSums<dim, S> sums_;
};

} // namespace slosh
