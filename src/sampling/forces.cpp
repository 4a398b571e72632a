// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/loadOnTank.hpp"

#include <sstream>

namespace slosh
{

namespace
{

/// Force and moment of the liquid on the tank, in all, by pressure and by viscosity: forces { CofR (x y z); axes tank;
/// }
class Forces final : public FunctionObject
{
public:
    Forces(const Vec& CofR, bool tankAxes, const FunctionSetting& setting)
        : CofR_(CofR), tankAxes_(tankAxes),
          force_(setting.folder / "force.dat", header("Force", CofR, tankAxes), setting.precision),
          moment_(setting.folder / "moment.dat", header("Moment", CofR, tankAxes), setting.precision)
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        const Load load = loadOnTank(snapshot, CofR_, tankAxes_);
        const Wrench total = load.total();
        write(force_, snapshot.state().time, total.force, load.pressure.force, load.viscous.force);
        write(moment_, snapshot.state().time, total.moment, load.pressure.moment, load.viscous.moment);
    }

    std::vector<std::filesystem::path> files() const override { return {force_.path(), moment_.path()}; }

private:
    static std::string header(const std::string& what, const Vec& CofR, bool tankAxes)
    {
        std::ostringstream out;
        out << "# " << what << "\n# CofR : (" << CofR[0] << " " << CofR[1] << " " << CofR[2]
            << ")\n# Axes : " << (tankAxes ? "tank" : "inertial")
            << "\n# Time\t(total_x total_y total_z)\t(pressure_x pressure_y pressure_z)\t(viscous_x viscous_y "
               "viscous_z)\n";
        return out.str();
    }

    static void write(SampleFile& file, double time, const Vec& total, const Vec& pressure, const Vec& viscous)
    {
        file.beginRow(time);
        file.addTabbed(total);
        file.addTabbed(pressure);
        file.addTabbed(viscous);
        file.endRow();
    }

    Vec CofR_;
    bool tankAxes_;
    SampleFile force_, moment_;
};

std::unique_ptr<FunctionObject> makeForces(const FunctionSetting& setting)
{
    const bool tankAxes = setting.dict.choiceOr("axes", "tank", {"tank", "inertial"}, "axes") == "tank";
    setting.dict.allow({"patches", "rho", "rhoInf", "pRef", "p", "U"});
    return std::make_unique<Forces>(setting.dict.vectorOr("CofR", Vec::Zero(), unit::metre), tankAxes, setting);
}

} // namespace

namespace choices
{
extern const FunctionObject::Choice forces = {
    "forces", "Force, [N], and moment, [N m], of the liquid on the tank: in all, by pressure and by viscosity",
    makeForces};
}

} // namespace slosh
