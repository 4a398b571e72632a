// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/samplePoint.hpp"

#include <sstream>

namespace slosh
{

namespace
{

namespace interfaceHeight
{

constexpr Key locations{
    .name = "locations",
    .example = "((0 -0.41 0) (0 0.41 0))",
    .unit = unit::metre,
    .sentence = "in the tank or on its walls"};

Keys all()
{
    return joined({locations}, withoutEffect({"alpha", "liquid", "direction", "interpolationScheme"}));
}

} // namespace interfaceHeight

/// Wave gauges, lines along the tank's vertical through points.
/// hB: height of the surface above the tank's bottom, hL: above the location, [m].
class InterfaceHeight final : public FunctionObject
{
public:
    InterfaceHeight(std::vector<Vec> locations, const FunctionSetting& setting)
        : locations_(std::move(locations)), file_(setting.folder / "height.dat", header(locations_), setting.precision)
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        const double bottom = snapshot.scene().tank.box().min().z();
        file_.beginRow(snapshot.state().time);
        for (const Vec& X : locations_)
        {
            const double level = surfaceLevel(snapshot, X);
            file_.addTabbed(level - bottom);
            file_.addTabbed(level - X.z());
        }
        file_.endRow();
    }

    std::vector<std::filesystem::path> files() const override { return {file_.path()}; }

private:
    static std::string header(const std::vector<Vec>& locations)
    {
        std::ostringstream out;
        std::string numbers = "# Location", names = "# Time";
        for (std::size_t k = 0; k < locations.size(); ++k)
        {
            out << "# Location : (" << locations[k][0] << " " << locations[k][1] << " " << locations[k][2] << ")\n";
            numbers += "\t" + std::to_string(k) + "\t ";
            names += "\thB\thL";
        }
        out << "# hB       : Interface height above the boundary\n# hL       : Interface height above the location\n"
            << numbers << "\n"
            << names << "\n";
        return out.str();
    }

    std::vector<Vec> locations_;
    SampleFile file_;
};

std::unique_ptr<FunctionObject> makeInterfaceHeight(const FunctionSetting& setting)
{
    return std::make_unique<InterfaceHeight>(pointsInTank(setting, interfaceHeight::locations), setting);
}

} // namespace

namespace choices
{
extern const FunctionObject::Choice interfaceHeight = {
    "interfaceHeight",
    "Height of the free surface at wave gauges, above the tank's bottom (hB) and above their locations (hL), along the "
    "tank's vertical, [m], in the file height.dat",
    makeInterfaceHeight, interfaceHeight::all};
}

} // namespace slosh
