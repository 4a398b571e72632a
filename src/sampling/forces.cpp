// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/loadsOnParts.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace slosh
{

namespace
{

namespace forces
{

constexpr Key patches{
    .name = "patches",
    .leftOut = "all",
    .example = "(walls)",
    .sentence = "parts of the tank: walls, and bodies of constant/tankProperties by name"};
constexpr Key CofR{
    .name = "CofR",
    .otherwise = "(0 0 0)",
    .example = "(0 0 0.31)",
    .unit = unit::metre,
    .sentence = "centre of the moment, in tank coordinates"};
constexpr Key axes{.name = "axes", .otherwise = "tank", .sentence = "directions of the components", .options = [] {
                       return Options{{"tank"}, {"inertial"}};
                   }};

Keys all()
{
    return joined({patches, CofR, axes}, withoutEffect({"rho", "rhoInf", "pRef", "p", "U"}));
}

} // namespace forces

/// Force and moment of the liquid on the tank or on some parts of it, in all, by pressure and by viscosity, and the
/// impulse of what was stopped at their walls.
class Forces final : public FunctionObject
{
public:
    Forces(std::vector<std::size_t> parts, const Vec& CofR, bool tankAxes, const FunctionSetting& setting)
        : parts_(std::move(parts)), CofR_(CofR), tankAxes_(tankAxes),
          force_(setting.folder / "force.dat", header("Force", "N s", setting), setting.precision),
          moment_(setting.folder / "moment.dat", header("Moment", "N m s", setting), setting.precision)
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        const TimeState& state = snapshot.state();
        const std::vector<Load> loads = loadsOnParts(snapshot, CofR_, tankAxes_);
        state.requireStopsOn(loads.size());
        Load load;
        Wrench stops;
        for (const std::size_t part : parts_)
        {
            load = load + loads[part];
            stops += state.stops.empty() ? Wrench() : state.stops[part].about(CofR_);
        }
        const Wrench total = load.total();
        write(force_, state.time, total.force, load.pressure.force, load.viscous.force, stops.force);
        write(moment_, state.time, total.moment, load.pressure.moment, load.viscous.moment, stops.moment);
    }

    std::vector<std::filesystem::path> files() const override { return {force_.path(), moment_.path()}; }

private:
    std::string header(const std::string& what, const std::string& unit, const FunctionSetting& setting) const
    {
        std::ostringstream out;
        out << "# " << what << "\n# CofR : (" << CofR_[0] << " " << CofR_[1] << " " << CofR_[2]
            << ")\n# Axes : " << (tankAxes_ ? "tank" : "inertial") << "\n# Patches :";
        const std::vector<std::string> names = setting.scene.tank.partNames();
        for (const std::size_t part : parts_)
        {
            out << " " << names[part];
        }
        out << "\n# Stops : impulse since the case began, [" << unit << "], axes of the tank"
            << "\n# Time\t(total_x total_y total_z)\t(pressure_x pressure_y pressure_z)\t(viscous_x viscous_y "
               "viscous_z)\t(stops_x stops_y stops_z)\n";
        return out.str();
    }

    template <class... Columns>
    static void write(SampleFile& file, double time, const Columns&... columns)
    {
        file.beginRow(time);
        (file.addTabbed(columns), ...);
        file.endRow();
    }

    std::vector<std::size_t> parts_; ///< as NearestWall::part counts
    Vec CofR_;
    bool tankAxes_;
    SampleFile force_, moment_;
};

/// All, where `patches` does not name some.
std::vector<std::size_t> partsIn(const Dictionary& dict, const Tank& tank)
{
    const std::vector<std::string> names = tank.partNames();
    std::set<std::size_t> parts;
    for (const std::string& patch : dict.has(forces::patches) ? dict.words(forces::patches) : names)
    {
        const auto found = std::find(names.begin(), names.end(), patch);
        if (found == names.end())
        {
            throw unknownName("part", patch, dict.placeOf(forces::patches), names);
        }
        parts.insert(static_cast<std::size_t>(found - names.begin()));
    }
    if (parts.empty())
    {
        throw dict.errorAt(forces::patches, "is empty; expected parts of the tank");
    }
    return {parts.begin(), parts.end()};
}

std::unique_ptr<FunctionObject> makeForces(const FunctionSetting& setting)
{
    const bool tankAxes = setting.dict.choice(forces::axes, "axes") == "tank";
    return std::make_unique<Forces>(
        partsIn(setting.dict, setting.scene.tank), setting.dict.vector(forces::CofR), tankAxes, setting
    );
}

} // namespace

namespace choices
{
extern const FunctionObject::Choice forces = {
    "forces",
    "Force, [N], and moment, [N m], of the liquid on the tank or parts of it, in the files force.dat and moment.dat: "
    "total, pressure and viscous; last the impulse of particles stopped at walls since the case began, [N s] and [N m "
    "s], along the tank's axes",
    makeForces, forces::all};
}

} // namespace slosh
