// SPDX-License-Identifier: GPL-3.0-or-later
// particlesToVTK: the written times of a case as files for ParaView, or as comma-separated text.
//
// VTK/fluid_<index>.vtu, VTK/wall_<index>.vtu, VTK/tank_<index>.vtp (the tank's outline), index = steps since the case
// began, and a .series file for each, which is what to open: the layout of foamToVTK, a file named after its cloud.
// With -surface also VTK/surface_<index>.vtp, the free surface.
// With -format csv: postProcessing/particles/<time>/{fluid,wall,tank}.csv.

#include "common/Program.hpp"
#include "common/selectTimes.hpp"
#include "particles/changeFrame.hpp"
#include "sampling/derivedField.hpp"
#include "vtk/writeSeries.hpp"
#include "vtk/writeSurface.hpp"
#include "vtk/writeTankOutline.hpp"
#include "vtk/writeVtu.hpp"

#include "liquidSurface.hpp"
#include "writeCsv.hpp"

#include <algorithm>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

using namespace slosh;

namespace
{

namespace fs = std::filesystem;

/// What the command line asks for.
struct Wanted
{
    Frame frame = Frame::inertial;
    bool csv = false;
    bool wall = true;
    bool surface = false;
    std::vector<std::string> fields = usualFields();
};

std::string oneOf(const Program& program, const std::string& option, const std::vector<std::string>& valid)
{
    std::string word = program.has(option) ? program.value(option) : valid.front();
    if (std::find(valid.begin(), valid.end(), word) == valid.end())
    {
        throw unknownName(option, word, "-" + option, valid);
    }
    return word;
}

/// '(p U)', 'p U' or p,U.
std::vector<std::string> readFields(std::string list)
{
    std::replace_if(
        list.begin(), list.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' '
    );
    std::istringstream in(list);
    return {std::istream_iterator<std::string>(in), {}};
}

/// Adds what is computed where it is asked for. Throws CaseError for a field that the time does not have either.
void addDerivedFields(Particles& particles, const std::vector<std::string>& fields, const Scene& scene)
{
    for (const std::string& field : fields)
    {
        const std::vector<std::string> present = fieldNames(particles);
        if (std::find(present.begin(), present.end(), field) == present.end())
        {
            particles.more.push_back(derivedField(field, particles, scene, present));
        }
    }
}

/// Writes files into the case, names each on stdout once it is there, and keeps what the series need.
class Output
{
public:
    using Write = std::function<void(const fs::path&)>;

    explicit Output(fs::path root) : root_(std::move(root)) {}

    void file(const std::string& name, const Write& write)
    {
        write(root_ / name);
        std::cout << "    " << name << "\n";
        ++count_;
    }
    /// VTK/<cloud>_<index>.<extension>, a file of the series VTK/<cloud>.<extension>.series.
    void ofSeries(const std::string& cloud, const std::string& extension, const TimeState& state, const Write& write)
    {
        const std::string name = cloud + "_" + std::to_string(state.index) + "." + extension;
        file("VTK/" + name, write);
        series_["VTK/" + cloud + "." + extension + ".series"].push_back({name, state.time});
    }
    void allSeries()
    {
        for (const auto& series : series_)
        {
            file(series.first, [&](const fs::path& path) { writeSeries(path, series.second); });
        }
        std::cout << "\n" << count_ << " files written in " << root_.string() << "\n";
    }

private:
    fs::path root_;
    std::map<std::string, std::vector<SeriesFile>> series_;
    int count_ = 0;
};

/// One time: liquid, walls (where wanted) and the tank's outline.
void writeOne(
    const Particles& particles, const TimeState& state, const TankOutline& outline, const std::string& timeName,
    const Wanted& wanted, Output& output
)
{
    const auto cloud = [&](const std::string& name, ParticleRange range)
    {
        if (wanted.csv)
        {
            output.file(
                "postProcessing/particles/" + timeName + "/" + name + ".csv",
                [&](const fs::path& file) { writeCsv(file, particles, range, wanted.fields); }
            );
        }
        else
        {
            output.ofSeries(
                name, "vtu", state,
                [&](const fs::path& file) { writeVtu(file, particles, range, wanted.fields, state.time); }
            );
        }
    };
    cloud("fluid", ParticleRange::liquid);
    if (wanted.wall)
    {
        cloud("wall", ParticleRange::wall);
    }
    if (wanted.csv)
    {
        output.file(
            "postProcessing/particles/" + timeName + "/tank.csv", [&](const fs::path& file) { writeCsv(file, outline); }
        );
    }
    else
    {
        output.ofSeries(
            "tank", "vtp", state, [&](const fs::path& file) { writeTankOutline(file, outline, state.time); }
        );
    }
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "particlesToVTK", "Converts particles to files for ParaView or to comma-separated text.",
        "particlesToVTK -case tutorials/rollingTank/roll8deg4rad -time 0.5:2 -fields '(p U)'"
    );
    addTimeOptions(program);
    program.addThreads();
    program.addOption(
        "frame", "inertial|tank", "frame of the output: the tank moves (inertial, default) or is fixed (tank)"
    );
    program.addOption(
        "fields", "list",
        "fields to write, e.g. '(p U vorticity)'; default: U p rho origId; also other fields of the time, and vorticity"
    );
    program.addOption("noWall", "", "omit the wall particles");
    program.addOption("surface", "", "also write the free surface: VTK/surface_<index>.vtp");
    program.addOption("format", "vtu|csv", "files for ParaView (vtu, the default) or comma-separated text");
    program.addFile("constant/*", "read; system/sphSchemes for suction at walls");
    program.addFile("<time>/", "read: the particles");
    program.addFile("VTK/", "written: fluid, wall, tank, surface; open the .series in ParaView");
    program.addFile("postProcessing/particles/<time>/", "written with -format csv: fluid.csv, wall.csv, tank.csv");
    program.addChoices("-fields, in addition to those of the time", derivedFields());
    return program.run(
        argc, argv,
        [&]
        {
            const Wanted wanted{
                frameNamed(oneOf(program, "frame", {"inertial", "tank"})),
                oneOf(program, "format", {"vtu", "csv"}) == "csv", !program.has("noWall"), program.has("surface"),
                program.has("fields") ? readFields(program.value("fields")) : usualFields()};
            if (wanted.csv && wanted.surface)
            {
                throw CaseError("-surface has no comma-separated form; omit -format csv");
            }
            const Case theCase(program.caseFolder());
            std::optional<Scene> scene;
            Output output(theCase.root());
            for (const TimeDirectory& time : selectTimes(theCase, program))
            {
                TimeState state;
                Particles particles = readTime(theCase, time.name, state);
                if (!scene)
                {
                    scene = Scene::read(theCase, particles.spacing);
                }
                changeFrame(particles, state.solverFrame(), wanted.frame);
                state.frame = wanted.frame;
                std::cout << "Time = " << time.name << ": " << particles.nFluid << " fluid particles, "
                          << particles.nWall << " wall particles\n";
                addDerivedFields(particles, wanted.fields, *scene);
                const TankOutline outline(scene->tank, state.solverFrame());
                writeOne(particles, state, outline, time.name, wanted, output);
                if (wanted.surface)
                {
                    const LiquidSurface liquid = liquidSurface(*scene, particles, state);
                    output.ofSeries(
                        "surface", "vtp", state,
                        [&](const fs::path& file) { writeSurface(file, liquid.surface, liquid.fields, state.time); }
                    );
                }
            }
            output.allSeries();
        }
    );
}
