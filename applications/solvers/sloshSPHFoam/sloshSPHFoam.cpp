// SPDX-License-Identifier: GPL-3.0-or-later
// Weakly compressible SPH of a liquid in a moving tank: the scheme of Cao, Ming & Zhang (2014).
#include "RunLog.hpp"
#include "common/Program.hpp"

#include "case/Controls.hpp"
#include "case/signals.hpp"
#include "integration/TimeIntegrator.hpp"
#include "motion/MotionFunction.hpp"
#include "particles/wallInTank.hpp"
#include "sampling/FunctionObjects.hpp"
#include "scene/Scene.hpp"
#include "solver/WeaklyCompressible.hpp"
#include "solver/startWarnings.hpp"
#include "solver/stepLimits.hpp"
#include "viscosities/readViscosity.hpp"

#include <csignal>
#include <iostream>
#include <sstream>

using namespace slosh;

namespace
{

void requireMotionUntilEnd(const SolidBodyMotion& motion, const Controls& time)
{
    // A rounding of the last row is forgiven, as the table itself does.
    if (motion.lastTime() < time.endTime() * (1 - 1e-9))
    {
        std::ostringstream what;
        what << "is " << time.endTime() << " s; expected at most " << motion.lastTime()
             << " s, the end of the tank's motion";
        throw time.dictionary().errorAt(endTimeKey(), what.str());
    }
}

/// Evaluates the start once: all that a run reads has been read by then.
void dryRun(WeaklyCompressible& solver, const Controls& time)
{
    const double maxCo = time.adjustTimeStep() ? time.maxCo() : 0.25;
    solver.updateNeighbours(0);
    solver.beginStep();
    std::cout << "Dry run: the case can be run. The largest initial time step is " << solver.stableTimeStep(maxCo)
              << " s (maxCo " << maxCo << ")\n";
}

/// What the command line asks for.
struct Options
{
    bool functions = true; ///< run those of controlDict
    bool dryRun = false;   ///< read and check all, write nothing
};

void sloshSPHFoam(const Case& theCase, const Options& options)
{
    Controls time(theCase);
    const Schemes schemes = Schemes::read(theCase.dictionaryIfPresent("system/sphSchemes"));
    TimeState start;
    Particles particles = readTime(theCase, time.startName(), start);
    time.resume(start.time, start.index, start.deltaT);

    const Scene scene = Scene::read(theCase, particles.spacing);
    requireMotionUntilEnd(*scene.motion, time);
    std::vector<Vec> walls = wallInTank(theCase, particles);
    time.limitDefaultMaxCo(maxCoOfStiffLiquid(scene));
    requireStableStep(scene, schemes, time);
    WeaklyCompressible solver(scene, schemes, std::move(particles), start, std::move(walls));
    FunctionObjects functions =
        options.functions
            ? FunctionObjects::read(time.dictionary(), theCase.root() / "postProcessing", scene, time.startName())
            : FunctionObjects();
    if (!options.functions)
    {
        time.dictionary().ignore({std::string(functionsKey().name)});
    }
    if (functions.wantBudget())
    {
        solver.keepEnergyBudget(start);
    }
    RunLog log(theCase, time, scene, solver, functions, startWarnings(scene, schemes, time, start));
    if (options.dryRun)
    {
        dryRun(solver, time);
        return;
    }

    const auto snapshot = [&]
    { return Snapshot(scene, solver.particles(), solver.sampledState(time.time(), time.index(), time.deltaT())); };
    const auto write = [&]
    {
        const auto section = solver.profile().section(Work::writing);
        writeTime(
            theCase, time.timeName(), solver.particles(), solver.state(time.time(), time.index(), time.deltaT()),
            time.writeOptions()
        );
        time.purge(theCase, time.timeName());
        solver.startAfresh(); // what a restart from here does, too
    };
    listenToSignals();
    try
    {
        while (time.running())
        {
            log.say(time.readIfModified([&](const Controls& changed) { requireStableStep(scene, schemes, changed); }));
            solver.updateNeighbours(time.adjustTimeStep() ? solver.longestTimeStep(time.maxCo()) : time.fixedDeltaT());
            solver.reinitialiseDensity(time.index());
            solver.beginStep();
            if (time.index() == 0)
            {
                const auto section = solver.profile().section(Work::functions);
                functions.executeAll(snapshot());
            }

            const double wanted = time.adjustTimeStep() ? solver.stableTimeStep(time.maxCo()) : time.fixedDeltaT();
            const double dt = time.limitDeltaT(wanted, functions.nextInstant(time.time()));
            time.advance(dt);

            solver.step(time.previousTime(), time.time());

            const bool sample = functions.isDue(time.before(), time.now());
            if (sample || time.isWriteTime() || !time.running())
            {
                solver.updatePressure();
            }
            if (sample)
            {
                const auto section = solver.profile().section(Work::functions);
                functions.execute(snapshot(), time.before(), time.now());
            }
            log.step();
            if (time.isWriteTime())
            {
                write();
            }
        }
    }
    catch (const UnphysicalRun& failure)
    {
        time.stepBack();
        solver.updatePressure();
        if (time.time() != start.time) // the start is there already
        {
            write();
        }
        throw CaseError(
            "at t = " + time.timeName() + " s " + failure.what() + "\nThe last valid state is in the time directory " +
            time.timeName()
        );
    }
    log.finish();
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "sloshSPHFoam", "Weakly compressible SPH of a liquid in a moving tank.",
        "sloshSPHFoam -case tutorials/rollingTank/roll8deg4rad -threads 2"
    );
    program.addThreads();
    program.addOption("noFunctionObjects", "", "do not execute the functions of system/controlDict");
    program.addOption("dry-run", "", "read and check the case, evaluate the initial state once, write nothing");
    program.addFile("constant/*, system/controlDict, system/sphSchemes", "read; system/probesDict if included");
    program.addFile("<time>/", "read at the start, written during the run: the particles and the position of the tank");
    program.addFile("postProcessing/<function>/<start time>/", "written: the samples of the functions in controlDict");
    program.addDictionary(
        {"constant/fluidProperties", "Entries of viscosity omitted here are set by the scheme (system/sphSchemes).",
         fluidPropertiesKeys}
    );
    program.addDictionary(
        {"constant/g", "Gravity, [m/s^2]. z is up: blockParticles fills the tank from its bottom, lowest z.",
         gravityKeys, "uniformDimensionedVectorField"}
    );
    program.addDictionary({"constant/kernelProperties", "The kernel of all pair sums.", kernelPropertiesKeys});
    program.addDictionary(
        {"constant/tankProperties",
         "The tank in its own coordinates: z up, x surge, y sway, roll about x. They are the inertial coordinates as "
         "long as the motion (dynamicMeshDict) has not moved the tank.",
         tankPropertiesKeys}
    );
    program.addDictionary(
        {"constant/dynamicMeshDict",
         "Motion of the tank, as in OpenFOAM. Without this file, or with staticFvMesh, the tank is at rest.",
         dynamicMeshDictKeys}
    );
    program.addDictionary({"system/controlDict", "Start and end of the run, time step and output.", controlDictKeys});
    program.addDictionary(
        {"system/sphSchemes", "Numerical schemes. Entries omitted here are set by the scheme.", sphSchemesKeys}
    );
    program.addDictionary(
        {"system/probesDict",
         "Functions executed while the solver runs, and afterwards by probeSample on the written times. Their names "
         "are free. Each writes postProcessing/<name>/<start time>/<file>, by default <type>.dat. Points are given in "
         "tank coordinates and move with the tank.\nEntries common to all functions are explained in the first one.",
         probesDictKeys}
    );
    program.addChoices("solidBodyMotionFunction in constant/dynamicMeshDict", MotionFunction::choices());
    program.addChoices("Function1 (omega, amplitude, ...) in constant/dynamicMeshDict", Function1::choices());
    program.addChoices("kernel in constant/kernelProperties", Kernel::choices());
    program.addChoices("type of viscosity in constant/fluidProperties", viscosityTypes());
    program.addChoices("timeIntegration in system/sphSchemes", TimeIntegrator::choices());
    program.addChoices("type of densityDiffusion in system/sphSchemes", Schemes::densityDiffusions());
    program.addChoices("type of functions in system/controlDict", FunctionObject::choices());
    const int status = program.run(
        argc, argv,
        [&] {
            sloshSPHFoam(Case(program.caseFolder()), {!program.has("noFunctionObjects"), program.has("dry-run")});
        }
    );
    // Whoever stops a script by the keyboard does not want its next program started.
    return status == 0 && stopSignal() == SIGINT ? 128 + SIGINT : status;
}
