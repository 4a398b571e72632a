// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConvertedCase.hpp"

#include "ConvertedMotion.hpp"
#include "ExtrudedTank.hpp"
#include "Fluid.hpp"
#include "Liquid.hpp"
#include "boundaries.hpp"
#include "decimal.hpp"
#include "dialect.hpp"
#include "functions.hpp"
#include "models.hpp"
#include "readBlockMesh.hpp"
#include "theirFiles.hpp"

#include "base/writeFile.hpp"
#include "case/foamFile.hpp"

#include <cmath>
#include <sstream>
#include <unistd.h>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

/// For the eye.
std::string rounded(double x)
{
    std::ostringstream text;
    text << x;
    return text.str();
}

std::string withHeader(const std::string& file, const std::string& text, const std::string& className = "dictionary")
{
    const fs::path path(file);
    return foamHeader(className, path.parent_path().string(), path.filename().string()) + "\n" + text;
}

std::string tankText(const ExtrudedTank& tank, const Liquid& liquid)
{
    static const std::array<std::string, 3> section{"yz", "xz", "xy"};
    const std::string& plane = section[tank.axis];
    Dictionary dict("constant/tankProperties");
    if (tank.isBox())
    {
        dict.set("type", "box");
        dict.set("min", Vec(tank.bounds().min()));
        dict.set("max", Vec(tank.bounds().max()));
    }
    else
    {
        std::string polygon;
        for (const auto& corner : tank.polygon)
        {
            polygon += " (" + numberText(corner.x()) + " " + numberText(corner.y()) + ")";
        }
        dict.set("type", "prism");
        dict.set("section", plane);
        dict.set("polygon", "(" + polygon + " )");
        dict.set("extent", "(" + numberText(tank.low) + " " + numberText(tank.high) + ")");
    }
    if (tank.flat)
    {
        dict.set("plane", plane);
    }
    if (liquid.level)
    {
        dict.set("fillLevel", *liquid.level);
        return dict.text();
    }
    Dictionary regions("liquid");
    for (std::size_t k = 0; k < liquid.regions.size(); ++k)
    {
        Dictionary box("box");
        box.set("type", "searchableBox");
        box.set("min", Vec(liquid.regions[k].min()));
        box.set("max", Vec(liquid.regions[k].max()));
        regions.set("box" + std::to_string(k), box);
    }
    dict.set("liquid", regions);
    return dict.text();
}

/// Liquid as far as a spacing can show it.
std::string fluidText(
    const Fluid& fluid, double speedOfSound, double viscousLength, double spacing, std::vector<std::string>& facts
)
{
    Dictionary dict("constant/fluidProperties"), state("equationOfState"), viscosity("viscosity");
    dict.set("rho0", "[1 -3 0 0 0 0 0] " + numberText(fluid.rho));
    const bool resolved = viscousLength > spacing;
    viscosity.set("type", resolved ? "laminar" : "lowDissipationRiemann");
    if (resolved)
    {
        viscosity.set("nu", fluid.nu);
    }
    viscosity.set("walls", resolved ? "noSlip" : "slip");
    state.set("speedOfSound", speedOfSound);
    dict.set("equationOfState", state);
    dict.set("viscosity", viscosity);
    facts.push_back(
        "Sound     : " + rounded(speedOfSound) + " m/s = 10 (sqrt(g D) + greatest speed of the walls in the run)"
    );
    facts.push_back(
        "Liquid    : rho0 " + numberText(fluid.rho) + " kg/m^3, nu " + numberText(fluid.nu) +
        " m^2/s, which acts over " + rounded(viscousLength) + " m: " +
        (resolved ? "viscosity laminar" : "less than a particle spacing, omitted (viscosity lowDissipationRiemann)")
    );
    return dict.text();
}

std::string controlText(const Dictionary& theirs, double lastTime, std::vector<std::string>& warnings)
{
    Dictionary dict("system/controlDict");
    double endTime = theirs.scalar("endTime", unit::second, positive);
    if (endTime > lastTime)
    {
        warnings.push_back(
            theirs.placeOf("endTime") + ": endTime is " + numberText(endTime) +
            ", later than the motion's table; the run ends with the table at " + numberText(lastTime) + " s"
        );
        endTime = lastTime;
    }
    if (theirs.scalarOr("startTime", 0, unit::second) != 0)
    {
        warnings.push_back(theirs.placeOf("startTime") + ": startTime is not 0; the run begins at 0");
    }
    const double deltaT = theirs.scalar("deltaT", unit::second, positive);
    const std::string control = theirs.wordOr("writeControl", "timeStep");
    const double interval = theirs.scalarOr("writeInterval", 1, unit::second, positive);
    const bool byClock = control == "clockTime" || control == "cpuTime";
    dict.set("application", "sloshSPHFoam");
    dict.set("startFrom", "latestTime");
    dict.set("stopAt", "endTime");
    dict.set("endTime", endTime);
    dict.set("adjustTimeStep", "yes");
    dict.set("maxCo", 0.8);
    dict.set("writeControl", byClock ? control : "adjustableRunTime");
    dict.set("writeInterval", control == "timeStep" ? decimal(interval * deltaT) : interval);
    dict.set("writeFormat", "binary");
    dict.set("writePrecision", 8L);
    dict.set("runTimeModifiable", "yes");
    return dict.text() + "functions\n{\n    #include \"probesDict\"\n}\n";
}

/// The largest of two digits with at least that number of particles.
double spacingFor(double volume, int dim, double particles)
{
    const double dx = std::pow(volume / particles, 1.0 / dim);
    const double unit = std::pow(10.0, std::floor(std::log10(dx)) - 1);
    return std::stod(
        numberText(std::floor(dx / unit + 1e-9)) + "e" +
        std::to_string(static_cast<int>(std::floor(std::log10(dx))) - 1)
    );
}

/// Their gravity, which must be constant.
struct Gravity
{
    Vec g; ///< [m/s^2]
    std::string place;
};

Gravity gravityOf(const Case& from)
{
    const Dictionary dict = dictionaryIn(from, "constant/g");
    if (dict.isDict("value") || (dict.has("value") && dict.tokens("value").size() != 5))
    {
        throw dict.errorAt("value", "is not constant; expected (x y z), as only the tank's motion can depend on time");
    }
    if (dict.has("dimensions"))
    {
        dict.requireDimensions("dimensions", unit::acceleration);
    }
    const Vec g = dict.vector("value", unit::acceleration);
    dict.refuseUnknown();
    return {g, dict.placeOf("value")};
}

/// A tank in our axes: gravity points along -z; where there is none a 2D section stands upright.
struct UprightTank
{
    ExtrudedTank theirs, ours;
    Turn turn;

    UprightTank(const BlockMesh& mesh, const Gravity& gravity) : theirs(ExtrudedTank::of(mesh)), ours(theirs)
    {
        const Vec& g = gravity.g;
        const bool lies = g.norm() == 0 && theirs.flat && theirs.axis == 2;
        const auto upright = Turn::upright(lies ? Vec(0, -1, 0) : g);
        if (!upright)
        {
            throw errorIn(gravity.place, "gravity is not along an axis; expected a case turned so that it is along -z");
        }
        turn = *upright;
        if (!turn.isNone())
        {
            ours = ExtrudedTank::of(mesh.turned(turn));
        }
        if (ours.flat && ours.axis == 2)
        {
            throw errorIn(
                gravity.place, "gravity is along the direction that is empty in " + mesh.file +
                                   "; expected a direction in the plane of the 2D tank"
            );
        }
    }
};

} // namespace

void ConvertedCase::convert(const Case& from, std::optional<double> spacing)
{
    const std::string dialect = dialectOf(from);
    try
    {
        convertFiles(from, spacing);
    }
    catch (const CaseError& error)
    {
        throw CaseError(
            error.what() + (dialect.empty() ? "" : "\nThe case is written for " + dialect + "."), error.kind()
        );
    }
    if (!dialect.empty())
    {
        facts.push_back("Dialect   : " + dialect);
    }
}

void ConvertedCase::convertFiles(const Case& from, std::optional<double> spacing)
{
    warnOfModels(from, warnings);
    const Gravity gravity = gravityOf(from);
    const Vec& g = gravity.g;
    const BlockMesh mesh = readBlockMesh(from);
    refuseOtherMeshers(from);
    warnOfPatches(from, mesh, warnings);
    const auto [theirTank, tank, turn] = UprightTank(mesh, gravity);
    const Liquid liquid = Liquid::read(dictionaryIn(from, "system/setFieldsDict"), turn, tank, warnings);
    const Fluid fluid = Fluid::read(from, liquid.field, warnings);
    const ConvertedMotion moved = ConvertedMotion::read(from, mesh, turn, warnings);
    const SolidBodyMotion& motion = *moved.motion;
    const Dictionary control = dictionaryIn(from, "system/controlDict");

    const int dim = tank.flat ? 2 : 3;
    const double volume = liquid.volume(tank), depth = liquid.depth(tank);
    const double dx =
        spacing.value_or(spacingFor(tank.flat ? volume / (tank.high - tank.low) : volume, dim, tank.flat ? 5000 : 50000)
        );
    std::ostringstream text;
    text << "Tank      : " << dim << "D, "
         << (tank.isBox() ? "a box" : "a prism of " + std::to_string(tank.polygon.size()) + " sides") << ", "
         << tank.bounds().sizes().transpose() << " m, " << tank.area() * (tank.high - tank.low) << " m^3\n"
         << "Fill      : " << depth << " m deep, " << volume << " m^3"
         << (liquid.level                 ? ""
             : liquid.regions.size() == 1 ? ", in a box"
                                          : ", in " + std::to_string(liquid.regions.size()) + " boxes")
         << "\n"
         << "Motion    : " << motion.description()
         << (turn.isNone() || motion.isStationary() ? "" : ", in the axes of the interFoam case");
    facts.push_back(text.str());
    if (!turn.isNone())
    {
        facts.push_back(
            "Axes      : turned so that gravity points along -z: x y z are " + turn.description() +
            " of the interFoam case"
        );
    }
    const double endTime = std::min(control.scalar("endTime", unit::second, positive), motion.lastTime());
    // The solver's own automatic choice looks beyond this end, where a motion such as SDA is ever faster.
    const double speed = motion.greatestSpeed(theirTank.bounds(), endTime, 10000, false);
    const double c0 = 10 * (std::sqrt(g.norm() * depth) + speed);
    if (c0 == 0)
    {
        throw errorIn(
            gravity.place,
            "gravity is 0 and the tank is at rest; expected one of both, from which the speed of sound is computed"
        );
    }
    const double seconds = g.norm() > 0 ? std::sqrt(depth / g.norm()) : endTime;
    const std::string fluidFile = fluidText(fluid, std::stod(rounded(c0)), std::sqrt(fluid.nu * seconds), dx, facts);
    const double deltaT = control.scalar("deltaT", unit::second, positive);
    const Dictionary functions =
        convertFunctions(from, control, {mesh, tank, turn, !motion.isStationary(), deltaT}, warnings);
    facts.push_back("Functions : " + std::to_string(functions.keys().size()));
    facts.push_back(
        "Spacing   : " + numberText(dx) + " m, " + rounded(depth / dx) + " in the depth" +
        (spacing ? "" : ", for about " + std::string(tank.flat ? "5000" : "50000") + " liquid particles; see -spacing")
    );

    const auto add = [&](const std::string& file, const std::string& entries)
    { files[file] = withHeader(file, entries); };
    copies = moved.copies;
    files = moved.tables;
    if (!moved.dynamicMeshDict.empty())
    {
        add("constant/dynamicMeshDict", moved.dynamicMeshDict);
    }
    add("constant/tankProperties", tankText(tank, liquid));
    add("constant/fluidProperties", fluidFile);
    add("constant/kernelProperties", "// The kernel is the scheme's (system/sphSchemes).\n");
    Dictionary gravityFile("constant/g");
    gravityFile.set("dimensions", "[0 1 -2 0 0 0 0]");
    gravityFile.set("value", turn(g));
    files["constant/g"] = withHeader("constant/g", gravityFile.text(), "uniformDimensionedVectorField");
    add("system/blockParticlesDict", "particleSpacing " + numberText(dx) + ";\n");
    add("system/controlDict", controlText(control, motion.lastTime(), warnings));
    add("system/sphSchemes", "frame           tank;\nscheme          recommended;\n");
    add("system/probesDict", functions.text());
}

void ConvertedCase::write(const Case& from, const fs::path& folder) const
{
    std::error_code failure;
    if (fs::exists(folder, failure) && !fs::is_empty(folder, failure))
    {
        throw CaseError(folder.string() + ": the folder is not empty; expected -to with a new or an empty folder");
    }
    fs::path whole = fs::absolute(folder).lexically_normal();
    whole = whole.has_filename() ? whole : whole.parent_path();
    const fs::path partial = whole.string() + ".partial." + std::to_string(::getpid());
    try
    {
        for (const auto& [file, text] : files)
        {
            writeFile(partial / file, text);
        }
        for (const auto& file : copies)
        {
            fs::create_directories((partial / file).parent_path());
            fs::copy_file(from.root() / file, partial / file);
        }
        fs::remove(whole);
        fs::rename(partial, whole);
    }
    catch (const fs::filesystem_error& error)
    {
        fs::remove_all(partial, failure);
        throw CaseError(folder.string() + ": cannot write the case: " + error.code().message());
    }
    catch (...)
    {
        fs::remove_all(partial, failure);
        throw;
    }
}

} // namespace slosh
