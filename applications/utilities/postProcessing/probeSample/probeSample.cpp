// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of the functions in system/controlDict from written times: for probes added after a run.
#include "common/Program.hpp"
#include "common/selectTimes.hpp"

#include "sampling/FunctionObjects.hpp"
#include "scene/Scene.hpp"

#include <iostream>

using namespace slosh;

namespace
{

/// The dictionary that holds functions { ... }: system/controlDict, or a file of functions alone.
Dictionary functionsOf(const Case& theCase, const Program& program)
{
    if (!program.has("dict"))
    {
        return theCase.dictionary("system/controlDict");
    }
    Dictionary dict(program.value("dict"));
    dict.set("functions", theCase.dictionary(program.value("dict")));
    return dict;
}

void probeSample(const Case& theCase, const Program& program)
{
    const auto times = selectTimes(theCase, program);
    TimeState state;
    Particles particles = readTime(theCase, times.front().name, state);
    const Scene scene = Scene::read(theCase, particles.spacing);
    FunctionObjects functions = FunctionObjects::read(
        functionsOf(theCase, program), theCase.root() / "postProcessing" / "probeSample", scene, times.front().name
    );
    // Apart from what the run itself wrote, which has more instants.
    if (functions.names().empty())
    {
        throw CaseError("system/controlDict: functions has no function to sample; expected one, or the option -dict");
    }
    for (const auto& time : times)
    {
        if (time.name != times.front().name)
        {
            particles = readTime(theCase, time.name, state);
        }
        std::cout << "Time = " << time.name << "\n";
        functions.executeAll(Snapshot(scene, particles, state));
    }
    std::cout << "\nWrote\n";
    for (const auto& file : functions.files())
    {
        std::cout << "    " << file.lexically_relative(theCase.root()).string() << "\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "probeSample", "Executes the functions of system/controlDict on written times.",
        "probeSample -case tutorials/rollingTank/roll8deg4rad -time 10:20 -dict system/probesDict"
    );
    addTimeOptions(program);
    program.addOption("dict", "file", "file of functions instead of those of controlDict, e.g. system/probesDict");
    program.addFile("constant/*, system/controlDict", "read; system/sphSchemes for suction at walls");
    program.addFile("<time>/", "read: the particles");
    program.addFile("postProcessing/probeSample/<function>/<first time>/", "written: the samples");
    return program.run(argc, argv, [&] { probeSample(Case(program.caseFolder()), program); });
}
