// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/samplePoint.hpp"

#include <sstream>

namespace slosh
{

namespace
{

/// Pressure at points fixed to the tank: probes { fields (p); probeLocations ((x y z) ...); }
class Probes final : public FunctionObject
{
public:
    Probes(std::vector<Vec> locations, const FunctionSetting& setting)
        : locations_(std::move(locations)), file_(setting.folder / "p", header(locations_), setting.precision)
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        file_.beginRow(snapshot.state().time);
        for (const Vec& X : locations_)
        {
            file_.add(pressureAt(snapshot, X));
        }
        file_.endRow();
    }

    std::vector<std::filesystem::path> files() const override { return {file_.path()}; }

private:
    static std::string header(const std::vector<Vec>& locations)
    {
        std::ostringstream out;
        std::string numbers = timeColumn("Probe");
        for (std::size_t k = 0; k < locations.size(); ++k)
        {
            out << "# Probe " << k << " (" << locations[k][0] << " " << locations[k][1] << " " << locations[k][2]
                << ")\n";
            numbers += sampleColumn(std::to_string(k));
        }
        out << numbers << "\n" << timeColumn("Time") << "\n";
        return out.str();
    }

    std::vector<Vec> locations_;
    SampleFile file_;
};

} // namespace

std::unique_ptr<FunctionObject> makeProbes(const FunctionSetting& setting)
{
    for (const auto& field : setting.dict.words("fields"))
    {
        if (field != "p")
        {
            throw unknownName("field", field, setting.dict.placeOf("fields"), {"p"});
        }
    }
    setting.dict.allow({"fixedLocations", "includeOutOfBounds", "interpolationScheme"});
    return std::make_unique<Probes>(pointsInTank(setting, "probeLocations"), setting);
}

} // namespace slosh
