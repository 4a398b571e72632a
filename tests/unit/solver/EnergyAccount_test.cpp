// SPDX-License-Identifier: GPL-3.0-or-later
// The energy budget against closed forms: each term where nothing else happens, and all together.
#include "solver/WeaklyCompressible.hpp"

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"
#include "particles/liquidEnergies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double rho0 = 1000, g = 9.81, dx = 0.01;

/// A motion given as a function of time.
class Prescribed final : public SolidBodyMotion
{
public:
    explicit Prescribed(std::function<RigidState(double)> state) : state_(std::move(state)) {}
    RigidState at(double time) const override { return state_(time); }
    std::string description() const override { return "prescribed"; }

private:
    std::function<RigidState(double)> state_;
};

/// The tank translates: height, velocity and acceleration along z.
Prescribed along(std::function<Vec(double)> zva)
{
    return Prescribed(
        [zva](double t)
        {
            RigidState state;
            const Vec z = zva(t);
            state.c.z() = z[0];
            state.velocity.z() = z[1];
            state.acceleration.z() = z[2];
            return state;
        }
    );
}

Kernel wendland(double hOverDx)
{
    return Kernel::read(
        Dictionary::parse("kernel wendlandC2; hOverDx " + std::to_string(hOverDx) + ";", "constant/kernelProperties"),
        2, dx
    );
}

/// A tank 0.2 m long and 0.1 m thick (2D), 0.1 m deep, filled as `tankText` says.
struct Water
{
    Scene scene;
    Schemes schemes;
    std::function<void(Particles&)> disturb = [](Particles&) {};
    double hydrostatic = g; ///< what the start is in equilibrium with
    int wallLayers = 4;

    explicit Water(
        const SolidBodyMotion& motion, double speedOfSound = 12,
        const std::string& tankText = "min (0 0 0); max (0.2 0.1 0.2); fillDepth 0.1;"
    )
        : scene{
              Tank::read(Dictionary::parse("type box; plane xz; " + tankText, "constant/tankProperties")),
              wendland(1.5),
              std::shared_ptr<const SolidBodyMotion>(std::shared_ptr<void>(), &motion), // which outlives it
              Vec(0, 0, -g),
              {rho0, speedOfSound, 7},
              {}}
    {
        schemes.precision = Precision::doublePrecision;
        schemes.densityInterval = 0;
        schemes.timeIntegration = "positionVerlet";
    }

    double mass() const { return rho0 * 0.2 * 0.1 * 0.1; }
};

/// What a run has left.
struct Outcome
{
    EnergyBudget budget;
    double energy = 0;        ///< in the inertial frame
    double kineticInTank = 0; ///< the largest
    double loss() const { return budget.initial + budget.work - energy; }
};

Outcome run(const Water& water, double end, double dt)
{
    Particles particles =
        fillTank(water.scene.tank, dx, water.wallLayers, rho0, water.scene.equationOfState, water.hydrostatic, 3)
            .particles;
    water.disturb(particles);
    const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
    TimeState start;
    start.tank = water.scene.motion->at(0);
    WeaklyCompressible solver(water.scene, water.schemes, std::move(particles), start, walls);
    solver.keepEnergyBudget(start);
    Outcome outcome;
    const long steps = std::lround(end / dt);
    for (long n = 0; n < steps; ++n)
    {
        const double t = static_cast<double>(n) * dt;
        solver.updateNeighbours(dt);
        solver.reinitialiseDensity(n);
        solver.beginStep();
        solver.step(t, t + dt);
        const TimeState now = solver.state(t + dt, n + 1, dt);
        const LiquidEnergies energies = liquidEnergies(
            solver.particles(), water.scene.equationOfState, water.scene.gravity, now.solverFrame(),
            water.scene.tank.thickness()
        );
        outcome.kineticInTank = std::max(outcome.kineticInTank, energies.kineticInTank);
        outcome.energy = energies.total();
        outcome.budget = *now.budget;
    }
    return outcome;
}

TEST(EnergyBudget, OfATankInFreeFallIsNoWorkAndNothingTaken)
{
    const Prescribed motion = along([](double t) { return Vec(-g * t * t / 2, -g * t, -g); });
    Water water(motion);
    water.hydrostatic = 0;
    water.scene.viscosity = ArtificialViscosity::of(water.scene.equationOfState, 0.1);
    water.schemes.densityDiffusion = 0.1;
    const Outcome fallen = run(water, 0.2, 2e-4);
    const double scale = water.mass() * g * g * 0.02; // kinetic energy: m (g t)^2/2
    EXPECT_NEAR(fallen.budget.work, 0, 1e-9 * scale);
    EXPECT_NEAR(fallen.budget.taken(), 0, 1e-9 * scale);
    EXPECT_NEAR(fallen.budget.residual(fallen.energy), 0, 1e-9 * scale);
    EXPECT_LT(fallen.kineticInTank, 1e-9 * scale);
}

TEST(EnergyBudget, OfAFallingTankThatIsKnockedDownWithinAStepIsNoWorkOnADropInIt)
{
    // 0.1 m/s more within a twentieth of a step, not in its middle: the liquid is left behind by just that.
    const double from = 0.01001, lasts = 1e-5, knock = -0.1;
    const Prescribed motion = along(
        [&](double t)
        {
            const double s = std::clamp((t - from) / lasts, 0.0, 1.0);
            const double fallen = knock * lasts * s * s / 2 + knock * std::max(0.0, t - from - lasts);
            return Vec(-g * t * t / 2 + fallen, -g * t + knock * s, -g + (s > 0 && s < 1 ? knock / lasts : 0));
        }
    );
    for (const std::string integrator : {"positionVerlet", "predictorCorrector"})
    {
        Water water(
            motion, 12,
            "min (0 0 0); max (0.2 0.1 0.2);"
            "liquid { drop { type searchableBox; min (0.06 0 0.06); max (0.14 0.1 0.14); } }"
        );
        water.hydrostatic = 0;
        water.schemes.timeIntegration = integrator;
        const Outcome fallen = run(water, 0.05, 2e-4);
        const double leftBehind = rho0 * 0.08 * 0.1 * 0.08 * knock * knock / 2;
        EXPECT_NEAR(fallen.kineticInTank / leftBehind, 1, 1e-9) << integrator;
        EXPECT_NEAR(fallen.budget.work / leftBehind, 0, 1e-9) << integrator;
        // Its place follows to second order in the step only: m g times half a step of the knock, at most.
        EXPECT_LT(std::abs(fallen.budget.residual(fallen.energy) / leftBehind), g * 2e-4 / std::abs(knock));
    }
}

TEST(EnergyBudget, OfATankLiftedAtConstantVelocityIsItsWeightTimesTheHeight)
{
    const Prescribed motion = along([](double t) { return Vec(1.5 * t, 1.5, 0); });
    for (const Frame frame : {Frame::tank, Frame::inertial})
    {
        Water water(motion);
        water.schemes.frame = frame;
        const Outcome lifted = run(water, 0.4, 2e-4);
        const double work = water.mass() * g * 1.5 * 0.4;
        EXPECT_NEAR(lifted.budget.work / work, 1, 0.003); // the liquid settles by some hundredths of a spacing
        EXPECT_GT(lifted.budget.positiveWork, lifted.budget.work * (1 - 1e-12));
        EXPECT_NEAR(lifted.budget.residual(lifted.energy) / work, 0, 1e-4);
    }
}

TEST(EnergyBudget, IsTheSameInBothFrames)
{
    // A roll about the middle of the bottom, 10 deg, with everything that takes energy.
    const Prescribed motion(
        [](double t)
        {
            const double a = -0.17, omega = 8;
            RigidState state;
            state.R = Eigen::AngleAxisd(a * std::sin(omega * t), Vec::UnitY()).toRotationMatrix();
            state.omega.y() = a * omega * std::cos(omega * t);
            state.omegaDot.y() = -a * omega * omega * std::sin(omega * t);
            return state;
        }
    );
    const auto rolled = [&](Frame frame)
    {
        Water water(motion);
        water.schemes.frame = frame;
        water.schemes.densityDiffusion = 0.1;
        water.schemes.densityInterval = 20;
        water.scene.viscosity = LaminarViscosity{0.01};
        // At rest in the tank's frame: what the solver starts with is the tank's.
        return run(water, 0.1, 1e-4);
    };
    const Outcome a = rolled(Frame::tank), b = rolled(Frame::inertial);
    const double scale = a.budget.positiveWork;
    EXPECT_GT(scale, 0);
    for (const auto term :
         {&EnergyBudget::work, &EnergyBudget::positiveWork, &EnergyBudget::viscosity, &EnergyBudget::densityDiffusion,
          &EnergyBudget::walls, &EnergyBudget::reinitialisation})
    {
        EXPECT_NE(a.budget.*term, 0);
        EXPECT_NEAR(a.budget.*term, b.budget.*term, 2e-4 * scale);
    }
    EXPECT_NEAR(a.budget.residual(a.energy) / scale, 0, 1e-3);
    EXPECT_NEAR(b.budget.residual(b.energy) / scale, 0, 1e-3);
}

/// The power viscosity takes from a square patch of n x n particles in free space that is strained, u = S x, w = -S z,
/// over that of the equations, 2 mu e : e = 4 mu S^2 a volume.
double strainedPatch(int n)
{
    const auto still = SolidBodyMotion::stationary();
    const double L = n * dx, S = 3, nu = 0.02;
    const std::string edge = std::to_string(L);
    Water water(*still, 50, "min (0 0 0); max (" + edge + " 0.1 " + edge + "); fillDepth " + edge + ";");
    water.scene.kernel = wendland(3); // on a lattice the sum is the integral only if the kernel is wide
    water.scene.gravity.setZero();
    water.hydrostatic = 0;
    water.wallLayers = 0;
    water.scene.viscosity = LaminarViscosity{nu};
    water.disturb = [&](Particles& particles)
    {
        for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
        {
            const Vec& r = particles.r[i];
            particles.v[i] = Vec(S * (r.x() - L / 2), 0, -S * (r.z() - L / 2));
        }
    };
    constexpr double dt = 1e-6;
    return run(water, dt, dt).budget.viscosity / (dt * 4 * rho0 * nu * S * S * L * L * 0.1);
}

TEST(EnergyBudget, OfAStrainedPatchHasTheDissipationOfTheEquations)
{
    // Particles at the edge have half their neighbours: the error falls with 1/n.
    const double coarse = strainedPatch(20), fine = strainedPatch(40);
    EXPECT_NEAR((1 - coarse) / (1 - fine), 2, 0.2);
    EXPECT_NEAR(2 * fine - coarse, 1, 0.02);
}

TEST(LongEnergyBudget, OfAViscousWaveIsTheEnergyItLoses)
{
    const auto still = SolidBodyMotion::stationary();
    for (const std::string& integrator : TimeIntegrator::names())
    {
        Water water(*still);
        water.schemes.timeIntegration = integrator;
        water.scene.viscosity = LaminarViscosity{2e-3};
        // Potential flow of the first mode: phi = cosh kz cos kx.
        const double k = std::numbers::pi / 0.2;
        water.disturb = [&](Particles& particles)
        {
            for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
            {
                const Vec& r = particles.r[i];
                particles.v[i] = 0.02 * Vec(-std::cosh(k * r.z()) * std::sin(k * r.x()), 0,
                                            std::sinh(k * r.z()) * std::cos(k * r.x()));
            }
        };
        const Outcome decayed = run(water, 0.8, 2e-4);
        EXPECT_NEAR(decayed.budget.work, 0, 1e-12) << "a tank at rest";
        EXPECT_GT(decayed.loss(), 0.5 * decayed.kineticInTank);
        EXPECT_NEAR(decayed.budget.taken() / decayed.loss(), 1, 0.01) << integrator;
        EXPECT_NEAR(decayed.budget.viscosity / decayed.loss(), 0.8, 0.1) << integrator; // the rest: walls
    }
}

/// Sound in a column, rho = rho0 (1 + a cos kz), k = 2 pi/H, with density diffusion delta = 0.2.
struct SoundingColumn : Water
{
    explicit SoundingColumn(const SolidBodyMotion& still, double H = 0.4)
        : Water(
              still, 20,
              "min (0 0 0); max (" + std::to_string(H / 2) + " 0.1 " + std::to_string(H) + "); fillDepth " +
                  std::to_string(H) + ";"
          )
    {
        scene.gravity.setZero();
        hydrostatic = 0;
        scene.wallSuction = true; // sound pulls as much as it pushes
        schemes.densityDiffusion = 0.2;
        disturb = [H](Particles& particles)
        {
            for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
            {
                particles.rho[i] = rho0 * (1 + 1e-4 * std::cos(2 * std::numbers::pi / H * particles.r[i].z()));
            }
        };
    }
};

TEST(EnergyBudget, OfAnAcousticColumnFallsByTheDensityDiffusionAndAtWalls)
{
    const auto still = SolidBodyMotion::stationary();
    const double period = 0.4 / 20;
    const Outcome rung = run(SoundingColumn(*still), 3 * period, period / 100);
    EXPECT_GT(rung.loss(), 0.4 * rung.budget.initial);
    EXPECT_NEAR((rung.budget.densityDiffusion + rung.budget.walls) / rung.loss(), 1, 0.002);
    EXPECT_GT(rung.budget.densityDiffusion, 0.5 * rung.loss());
}

TEST(EnergyBudget, OfAnAcousticColumnHasThePowerOfTheDiffusionEquation)
{
    // drho/dt = delta h c0 laplacian rho = -delta h c0 k^2 (rho - rho0): the internal energy falls at twice that rate.
    // Particles at the two walls, which are left out, have half their neighbours: the error falls with the spacing over
    // H.
    const auto still = SolidBodyMotion::stationary();
    const auto share = [&](double H)
    {
        const SoundingColumn water(*still, H);
        constexpr double dt = 1e-7;
        const Outcome first = run(water, dt, dt);
        const double rate = 2 * 0.2 * water.scene.kernel.smoothingLength() * 20 * std::pow(2 * std::numbers::pi / H, 2);
        return first.budget.densityDiffusion / (dt * rate * first.budget.initial);
    };
    const double coarse = share(0.4), fine = share(0.8);
    EXPECT_NEAR((1 - coarse) / (1 - fine), 2, 0.7);
    EXPECT_NEAR(2 * fine - coarse, 1, 0.02);
}

TEST(EnergyBudget, CountsWhatReinitialisingTheDensityTakes)
{
    // Noise is smoothed at the second step; nothing else happens to a liquid at rest in so short a time.
    const auto still = SolidBodyMotion::stationary();
    Water water(*still);
    water.scene.gravity.setZero();
    water.hydrostatic = 0;
    water.schemes.densityInterval = 1;
    water.disturb = [](Particles& particles)
    {
        for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
        {
            particles.rho[i] *= 1 + 1e-3 * std::sin(13.0 * particles.id[i]);
        }
    };
    const Outcome smoothed = run(water, 2e-7, 1e-7);
    EXPECT_GT(smoothed.budget.reinitialisation, 0.3 * smoothed.budget.initial);
    EXPECT_NEAR(smoothed.budget.reinitialisation / smoothed.loss(), 1, 1e-3);
}

TEST(EnergyBudget, IsThatOfTheLastGoodStateAfterAStepThatWentWrong)
{
    const auto still = SolidBodyMotion::stationary();
    const Water water(*still);
    Particles particles = fillTank(water.scene.tank, dx, 4, rho0, water.scene.equationOfState, g, 3).particles;
    const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
    TimeState start;
    start.tank = still->at(0);
    WeaklyCompressible solver(water.scene, water.schemes, std::move(particles), start, walls);
    EXPECT_FALSE(solver.state(0, 0, 0).budget) << "nobody has asked for it";
    solver.keepEnergyBudget(start);
    solver.updateNeighbours(1);
    solver.beginStep();
    solver.step(0, 1e-4);
    const EnergyBudget good = *solver.state(1e-4, 1, 1e-4).budget;
    EXPECT_NE(good.walls, 0);
    solver.beginStep();
    EXPECT_THROW(solver.step(1e-4, 1), UnphysicalRun);
    EXPECT_EQ(solver.state(1e-4, 1, 1e-4).budget->walls, good.walls);
    EXPECT_EQ(solver.state(1e-4, 1, 1e-4).budget->work, good.work);
}

} // namespace
} // namespace slosh
