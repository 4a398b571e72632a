// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the tank with particles and writes time 0.
#include "common/Program.hpp"

#include "case/Case.hpp"
#include "case/TimeStepControl.hpp"
#include "case/polyMesh.hpp"
#include "filling/fillTank.hpp"
#include "filling/initialFields.hpp"
#include "geometry/shapeTypes.hpp"
#include "integration/TimeIntegrator.hpp"
#include "particles/particleFiles.hpp"
#include "scene/Scene.hpp"
#include "solver/WeaklyCompressible.hpp"
#include "solver/abruptStart.hpp"
#include "solver/settle.hpp"
#include "solver/stepLimits.hpp"

#include <cmath>
#include <iostream>
#include <numbers>

using namespace slosh;

namespace
{

namespace blockParticlesDict
{

constexpr Key wallLayers{
    .name = "wallLayers",
    .otherwise = "4",
    .range = between(0, 20),
    .sentence = "number of layers of wall particles; must fill the kernel's support. 0: free space, no walls around "
                "the tank's box"};
constexpr Key abruptStart{
    .name = "abruptStart",
    .otherwise = "potentialFlow",
    .sentence = "how the liquid responds to that velocity",
    .options = []
    {
        return Options{
            {"potentialFlow", "immediately, as an incompressible liquid; some hundred steps"},
            {"sound", "by sound waves, which persist and may lift the liquid off the bottom; used by scheme cao2014"}};
    }};

constexpr Key settlingTime{
    .name = "time",
    .otherwise = "0",
    .example = "0.5",
    .unit = unit::second,
    .range = notNegative,
    .sentence = "duration; 0: no settling. A few periods of the first mode if small waves matter"};
constexpr Key settle{
    .name = "settle",
    .leftOut = "none; 1 s in scheme smallWaves",
    .sentence = "lets the liquid come to rest under gravity before the tank moves or U of initialFields is set. Needs "
                "gravity and walls, and no p of initialFields: otherwise an error, or ignored if set by a scheme",
    .entries = [] { return Keys{settlingTime}; }};

} // namespace blockParticlesDict

/// All entries of system/blockParticlesDict.
Keys blockParticlesKeys()
{
    using namespace blockParticlesDict;
    return {particleSpacingKey(),       wallLayers,        liquidAtRestKey(), abruptStart,
            blockParticlesDict::settle, initialFieldsKey()};
}

/// `settle { time ...; }`, [s]. That of a scheme is left out where the liquid cannot settle.
double timeToSettle(const Dictionary& dict, bool canSettle)
{
    using blockParticlesDict::settle;
    const Dictionary settling = dict.dictOr(settle);
    const double time = settling.scalar(blockParticlesDict::settlingTime);
    settling.refuseUnknown(settle.entries());
    if (time == 0 || canSettle)
    {
        return time;
    }
    const std::string condition = "needs gravity and walls, and no 'p' of initialFields";
    if (!dict.isDefault("settle/time"))
    {
        throw dict.errorAt(settle, condition);
    }
    std::cout << "Not settled: " << dict.placeOf("settle/time") << ": settle " << condition << "\n";
    return 0;
}

/// The step that sloshSPHFoam will take in still liquid, [s].
double expectedTimeStep(const TimeStepControl& control, const Scene& scene, const Schemes& schemes)
{
    const double factor = TimeIntegrator::make(schemes.timeIntegration)->viscosityFactor();
    return control.adjust ? longestTimeStep(scene, factor, control.maxCoUpTo(maxCoOfStiffLiquid(scene)))
                          : control.deltaT;
}

/// What a run of this case will need, from what runs have needed (docs/performance.md).
void reportCost(const Particles& particles, const Scene& scene, const Schemes& schemes, double dt)
{
    const auto liquid = static_cast<double>(particles.nFluid), walls = static_cast<double>(particles.nWall);
    const auto within = [&](double supports)
    {
        const double reach = supports * scene.kernel.supportRadius() / particles.spacing;
        return scene.tank.dim() == 2 ? std::numbers::pi * reach * reach
                                     : 4 * std::numbers::pi / 3 * reach * reach * reach;
    };
    // Lists reach 1.15 supports. 0.6 (with friction at walls) to 1.15 of what seven runs of the tutorials took.
    const double bytes = liquid * (270 + 0.9 * within(1.15)) + walls * 110;
    // By particle and step on one core with AVX-512, without functions: 0.8 to 1.2 of what they took.
    const double seconds = liquid * (25e-9 + 4e-9 * within(1) + (schemes.soundDamping > 0 ? 50e-9 : 0)) + walls * 60e-9;
    std::cout << "Estimates for sloshSPHFoam on one core\n    memory                 : " << bytes / 1e6
              << " MB\n    steps per second of time: " << 1 / dt
              << " in still liquid\n    run time per second     : " << seconds / dt
              << " s, up to twice as much depending on processor and flow\n";
}

void reportFrequencies(const Tank& tank, double gravity)
{
    const auto box = tank.boxUnderSurface();
    if (!box)
    {
        std::cout << "Natural frequencies of the tank: unknown, the still surface is not a single rectangle\n";
        return;
    }
    std::cout << "Natural frequencies of "
              << (tank.liquidIsBox()
                      ? "the tank"
                      : "a box with the breadth of the still surface and the depth of the tank, not of this " +
                            tank.walls().name())
              << ", linear theory\n";
    int mode = 0;
    for (const double omega : tank.naturalFrequencies(gravity, 3))
    {
        std::cout << "    omega" << ++mode << " = " << omega << " rad/s, period " << 2 * std::numbers::pi / omega
                  << " s\n";
    }
}

void blockParticles(const Case& theCase)
{
    using blockParticlesDict::abruptStart;
    const Dictionary dict = theCase.dictionary("system/blockParticlesDict");
    const double dx = dict.scalar(particleSpacingKey());
    const Scene wanted = Scene::read(theCase, dx);
    const Tank& tank = wanted.tank;
    const Kernel& kernel = wanted.kernel;
    const FluidProperties& fluid = wanted.fluid;
    const Vec& gravity = wanted.gravity;
    const TaitEquation& equationOfState = wanted.equationOfState;
    const double reachOverDx = kernel.supportRadius() / dx;
    const long wallLayers = dict.label(blockParticlesDict::wallLayers);
    if (wallLayers > 0 && static_cast<double>(wallLayers) < std::floor(reachOverDx + 0.5))
    {
        throw dict.errorAt(
            blockParticlesDict::wallLayers,
            "is " + std::to_string(wallLayers) + ", less than the kernel's support of " + std::to_string(reachOverDx) +
                " spacings; expected at least " + std::to_string(std::lround(std::floor(reachOverDx + 0.5))) +
                ", or 0 for liquid in free space"
        );
    }
    const Dictionary initialFields = dict.dictOr(initialFieldsKey());
    if (initialFields.has(initialVelocityKey()) && dict.has(liquidAtRestKey()))
    {
        throw dict.errorAt(liquidAtRestKey(), "and U of initialFields are both set; expected one of them");
    }
    const bool restInTank = dict.choice(liquidAtRestKey(), "liquidAtRest") == "tankFrame";
    const bool bySound = dict.choice(abruptStart, "abruptStart") == "sound";
    const double settlingTime =
        timeToSettle(dict, !initialFields.has(initialPressureKey()) && gravity.norm() > 0 && wallLayers > 0);
    dict.refuseUnknown(blockParticlesKeys());

    Filling filling =
        fillTank(tank, dx, static_cast<int>(wallLayers), fluid.rho0, equationOfState, gravity.norm(), reachOverDx);
    Particles& particles = filling.particles;
    TimeState start;
    start.tank = wanted.motion->at(0);
    if (!restInTank)
    {
        for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
        {
            particles.v[i] = -(start.tank.R.transpose() * start.tank.velocityAt(particles.r[i]));
            if (tank.emptyDirection() >= 0)
            {
                particles.v[i][tank.emptyDirection()] = 0;
            }
        }
    }

    const double mass = particles.mass * static_cast<double>(particles.nFluid) * tank.thickness();
    std::cout << tank.dim() << (tank.isBox() ? "D tank: " : "D tank, a " + tank.walls().name() + " within ")
              << tank.box().sizes().transpose() << " m, liquid depth " << tank.fillDepth() << " m, volume "
              << tank.fill().volume() << " m^3\n"
              << "Liquid particles: " << particles.nFluid << "\nWall particles  : " << particles.nWall
              << "\nSpacing         : " << particles.spacing << " m (requested " << dx
              << " m), h = " << kernel.smoothingLength() << " m, " << tank.fillDepth() / particles.spacing
              << " spacings over the depth\nMass            : " << mass << " kg = rho0 V to "
              << std::abs(mass / (fluid.rho0 * tank.fill().volume()) - 1) << "\n";
    for (const auto& line : filling.adjustments)
    {
        std::cout << "Adjusted        : " << line << "\n";
    }
    std::cout << "Speed of sound  : " << equationOfState.c0 << " m/s" << (fluid.speedOfSound ? "" : " (auto)")
              << "\nTait's rho0     : " << equationOfState.rho0
              << " kg/m^3 at the surface, so that the liquid's mean is " << fluid.rho0
              << "\nLargest pressure: " << equationOfState.hydrostatic(gravity.norm(), tank.fillDepth())
              << " Pa at rest\n";
    if (tank.fill().fromWallToWall() && gravity.norm() > 0)
    {
        reportFrequencies(tank, gravity.norm());
    }
    Schemes schemes = Schemes::read(theCase.dictionaryIfPresent("system/sphSchemes"));
    const Dictionary control = theCase.dictionary("system/controlDict");
    const double dt = expectedTimeStep(TimeStepControl::read(control), wanted, schemes);
    control.ignore(control.keys()); // the rest is the solver's
    reportCost(particles, wanted, schemes, dt);

    // The walls' pressure at the start, by the solver's own equations.
    schemes.frame = Frame::tank;
    const Scene scene = wanted.withSpacing(particles.spacing);
    if (settlingTime > 0)
    {
        const Settled settled = settle(scene, schemes, start.tank.R.transpose() * gravity, settlingTime, particles);
        std::cout << "Settled in " << settled.steps << " steps: particles moved by up to "
                  << settled.moved / particles.spacing << " spacings, at up to " << settled.speedOnWay
                  << " m/s; residual speed " << settled.speedLeft << " m/s\n";
    }
    if (!bySound && wallLayers > 0 && !initialFields.has(initialVelocityKey()))
    {
        const AbruptStart abrupt = startAbruptly(scene, particles);
        if (abrupt.steps > 0)
        {
            std::cout << "Abrupt start: the liquid starts with potential flow, "
                      << 100 * abrupt.energyAfter / abrupt.energyBefore
                      << " % of the kinetic energy (relative to the tank) of liquid at rest (" << abrupt.steps
                      << " steps)\n";
        }
    }
    setInitialFields(initialFields, tank, equationOfState, particles);
    std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
    WeaklyCompressible solver(scene, schemes, std::move(particles), start, std::move(walls));
    solver.updateNeighbours(0);
    solver.updatePressure();

    WriteOptions options;
    options.format = WriteFormat::binary;
    writeTime(theCase, "0", solver.particles(), start, options);
    BoundingBox box;
    for (const Vec& r : solver.particles().r)
    {
        box.extend(r);
    }
    box.min().array() -= solver.particles().spacing;
    box.max().array() += solver.particles().spacing;
    writePolyMesh(theCase, box);
    writeMinimalFvFiles(theCase);
    for (const auto& entry : theCase.unusedEntries())
    {
        std::cout << "Not used: " << entry << "\n";
    }
    std::cout << "\nWrote 0/lagrangian/fluid, 0/lagrangian/wall, constant/polyMesh, " << theCase.name() << ".foam\n";
    if (theCase.times().size() > 1)
    {
        std::cout << "--> FOAM Warning: later time directories exist; with startFrom latestTime a run continues from "
                  << theCase.times().back().name << "\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "blockParticles", "Fills the tank with particles and writes time 0.",
        "blockParticles -case tutorials/rollingTank/roll8deg4rad"
    );
    program.addThreads();
    program.addFile(
        "constant/*, system/blockParticlesDict",
        "read; system/sphSchemes if the liquid settles, system/controlDict to estimate the run"
    );
    program.addFile("0/", "written: the particles; constant/polyMesh and <case>.foam for ParaView");
    program.addDictionary(
        {"system/blockParticlesDict", "Filling of the tank and initial state of the liquid.", blockParticlesKeys}
    );
    program.addChoices("type in constant/tankProperties", wallTypes());
    program.addChoices("type of a body in geometry of constant/tankProperties", bodyTypes());
    return program.run(argc, argv, [&] { blockParticles(Case(program.caseFolder())); });
}
