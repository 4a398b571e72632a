// SPDX-License-Identifier: GPL-3.0-or-later
// The terms that may stand beside Eq. 1: viscosities, density diffusion.
#include "pairBlock.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace slosh
{
namespace
{

/// The terms beside Eq. 1 as their papers print them, over all pairs.
struct Terms
{
    std::function<Vec(std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW)> acceleration;
    std::function<double(std::size_t a, std::size_t b, const Vec& r, const Vec& gradW)> densityRate;
};

template <int dim>
Rates withTerms(const Particles& particles, const Kernel& kernel, const Terms& terms)
{
    Rates rates = asPrinted<dim>(particles, kernel, 0, 7);
    for (std::size_t a = 0; a < static_cast<std::size_t>(particles.nFluid); ++a)
    {
        for (std::size_t b = 0; b < particles.r.size(); ++b)
        {
            const Vec r = particles.r[a] - particles.r[b];
            if (a == b || r.norm() >= kernel.supportRadius())
            {
                continue;
            }
            const Vec gradW = kernel.gradFactor(r.norm()) * r;
            if (terms.acceleration)
            {
                rates.acceleration[a] += terms.acceleration(a, b, r, particles.v[a] - particles.v[b], gradW);
            }
            if (terms.densityRate)
            {
                rates.densityRate[a] += terms.densityRate(a, b, r, gradW);
            }
        }
    }
    return rates;
}

template <int dim>
void expectTermsAsPrinted()
{
    const Particles particles = block(dim, dim == 2 ? 24 : 9, 0.2);
    const Kernel kernel(WendlandC2{}, dim, 1.2 * dx);
    const double h = kernel.smoothingLength(), nu = 0.02;
    const auto& rho = particles.rho;

    Terms laminar;
    laminar.acceleration = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW) -> Vec
    {
        return particles.mass * 2 * (dim + 2) * nu * 2 / (rho[a] + rho[b]) * v.dot(r) /
               (r.squaredNorm() + 0.01 * h * h) * gradW;
    };
    EXPECT_LT(relativeDifference(ratesOf<dim, WendlandC2, double>(particles, LaminarViscosity{nu, h}),
                                 withTerms<dim>(particles, kernel, laminar)),
              1e-12);

    const auto nFluid = static_cast<std::size_t>(particles.nFluid);
    Terms slipping;
    slipping.acceleration = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW) -> Vec
    { return b < nFluid ? laminar.acceleration(a, b, r, v, gradW) : Vec::Zero().eval(); };
    const LaminarViscosity alongWalls{nu, h, static_cast<int>(nFluid)};
    const Rates slippingRates = withTerms<dim>(particles, kernel, slipping);
    EXPECT_LT(relativeDifference(ratesOf<dim, WendlandC2, double>(particles, alongWalls), slippingRates), 1e-12);
    EXPECT_GT(relativeDifference(ratesOf<dim, WendlandC2, double>(particles, LaminarViscosity{nu, h}), slippingRates),
              1e-3);

    // p* - (p_a + p_b)/2 = rho c0 U min(3 U/c0, 1)/2 with rho = 2 rho_a rho_b/(rho_a + rho_b)...: Pi = 2 p*/(rho_a
    // rho_b)
    Terms riemann;
    riemann.acceleration = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& v, const Vec& gradW) -> Vec
    {
        const double U = std::max(-v.dot(r) / r.norm(), 0.0);
        const double meanRho = (rho[a] + rho[b]) / 2;
        const double pStar = 0.5 * meanRho * c0 * U * std::min(3 * U / c0, 1.0);
        return -particles.mass * 2 * pStar / (rho[a] * rho[b]) * gradW;
    };
    EXPECT_LT(relativeDifference(ratesOf<dim, WendlandC2, double>(particles, LowDissipationRiemann{c0}),
                                 withTerms<dim>(particles, kernel, riemann)),
              1e-9);

    // Fourtakas' term with gamma = 1, where c is c0 at any density.
    const Vec g(1, 0, -9.81);
    const double delta = 0.1;
    Terms fourtakas;
    fourtakas.acceleration = {};
    fourtakas.densityRate = [&](std::size_t a, std::size_t b, const Vec& r, const Vec& gradW)
    {
        const double hydrostatic = (rho[a] + rho[b]) / 2 * g.dot(-r) / (c0 * c0);
        const Vec psi = 2 * (rho[b] - rho[a] - hydrostatic) * (-r) / r.squaredNorm();
        return delta * h * c0 * particles.mass / rho[b] * psi.dot(gradW);
    };
    Rates expected = withTerms<dim>(particles, kernel, fourtakas);
    for (Vec& a : expected.acceleration)
    {
        a += dim == 2 ? Vec(g.x(), 0, g.z()) : g;
    }
    EXPECT_LT(relativeDifference(ratesOf<dim, WendlandC2, double>(particles, NoViscosity{},
                                                                  FourtakasDensityDiffusion{delta, c0, rho0, 1},
                                                                  BodyForce::inTankFrame(g, RigidState())),
                                 expected),
              1e-12);
}

TEST(PairTerms, AreThoseOfTheirPapers)
{
    expectTermsAsPrinted<2>();
    expectTermsAsPrinted<3>();
}

template <class Viscosity, class Diffusion>
void expectPrecisionsAgree(const Viscosity& viscosity, const Diffusion& diffusion)
{
    const Particles particles = block(3, 10, 0.2);
    const BodyForce force = BodyForce::inTankFrame(Vec(1, 2, -9.81), RigidState());
    const Rates reference = ratesOf<3, WendlandC2, double>(particles, viscosity, diffusion, force);
    EXPECT_LT(
        (relativeDifference(ratesOf<3, WendlandC2, Simd<float>>(particles, viscosity, diffusion, force), reference)),
        2e-5);
    EXPECT_LT(
        (relativeDifference(ratesOf<3, WendlandC2, Simd<double>>(particles, viscosity, diffusion, force), reference)),
        1e-12);
}

TEST(PairTerms, OfFloatAndDoubleVectorsAgreeWithTheScalarReference)
{
    const NoDensityDiffusion none;
    expectPrecisionsAgree(LaminarViscosity{0.02, 1.2 * dx}, none);
    expectPrecisionsAgree(LaminarViscosity{0.02, 1.2 * dx, 100}, none); // within vectors, some lanes take part
    expectPrecisionsAgree(LowDissipationRiemann{c0}, none);
    expectPrecisionsAgree(NoViscosity{}, FourtakasDensityDiffusion{0.1, c0, rho0, 7});
}

TEST(FourtakasDensityDiffusion, LeavesLiquidAtRestInAnAcceleratedTankAlone)
{
    // c0^2 (rho/rho0)^(gamma - 1) d rho = rho b . dr, integrated.
    constexpr double gamma = 7;
    Particles particles = block(2, 24, 0.0);
    const Vec b(3, 0, -9.81);
    for (std::size_t i = 0; i < particles.r.size(); ++i)
    {
        particles.rho[i] = rho0 * std::pow(1 + (gamma - 1) * b.dot(particles.r[i]) / (c0 * c0), 1 / (gamma - 1));
        particles.v[i].setZero();
    }
    const FourtakasDensityDiffusion diffusion{0.1, c0, rho0, gamma};
    const auto largest = [&](const BodyForce& force)
    {
        double most = 0;
        for (const double D : ratesOf<2, WendlandC2, double>(particles, NoViscosity{}, diffusion, force).densityRate)
        {
            most = std::max(most, std::abs(D));
        }
        return most;
    };
    EXPECT_LT(largest(BodyForce::inTankFrame(b, RigidState())), 2e-4 * largest(noForce()));
}

} // namespace
} // namespace slosh
