#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/loadOnTank.hpp"

#include <sstream>

namespace slosh
{

namespace
{

/// Total force and moment of the liquid on the tank: forces { CofR (x y z); axes tank; }
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
        write(force_, snapshot.state().time, load.force);
        write(moment_, snapshot.state().time, load.moment);
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

    /// All of it is pressure.
    static void write(SampleFile& file, double time, const Vec& total)
    {
        file.beginRow(time);
        file.addTabbed(total);
        file.addTabbed(total);
        file.addTabbed(Vec(Vec::Zero()));
        file.endRow();
    }

    Vec CofR_;
    bool tankAxes_;
    SampleFile force_, moment_;
};

} // namespace

std::unique_ptr<FunctionObject> makeForces(const FunctionSetting& setting)
{
    const bool tankAxes = setting.dict.choiceOr("axes", "tank", {"tank", "inertial"}, "axes") == "tank";
    setting.dict.allow({"patches", "rho", "rhoInf", "pRef", "p", "U"});
    return std::make_unique<Forces>(setting.dict.vectorOr("CofR", Vec::Zero(), unit::metre), tankAxes, setting);
}

} // namespace slosh
