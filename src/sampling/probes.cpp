// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/sensorFace.hpp"

#include <sstream>

namespace slosh
{

namespace
{

namespace probes
{

constexpr Key fields{
    .name = "fields",
    .example = "(p)",
    .sentence = "p, the pressure, is the only field: 0 without liquid; max(p, 0) within half a spacing of a wall, "
                "unless suction is yes in sphSchemes"};
constexpr Key probeLocations{
    .name = "probeLocations",
    .example = "((0 -0.46 0.06) (0 0.46 0.06))",
    .unit = unit::metre,
    .sentence = "in the tank or on its walls"};

Keys all()
{
    return joined(
        joined({fields, probeLocations}, faceFormKeys()),
        withoutEffect({"fixedLocations", "includeOutOfBounds", "interpolationScheme"})
    );
}

} // namespace probes

/// Pressure at points fixed to the tank, or in the mean over the faces of sensors there.
class Probes final : public FunctionObject
{
public:
    Probes(const std::vector<Vec>& locations, const std::optional<FaceForm>& form, const FunctionSetting& setting)
        : sensors_(sensorsAt(locations, form, setting)),
          file_(setting.folder / "p", header(locations, form), setting.precision)
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        file_.beginRow(snapshot.state().time);
        for (const SensorFace& sensor : sensors_)
        {
            file_.add(sensor.pressure(snapshot));
        }
        file_.endRow();
    }

    std::vector<std::filesystem::path> files() const override { return {file_.path()}; }

private:
    static std::string header(const std::vector<Vec>& locations, const std::optional<FaceForm>& form)
    {
        std::ostringstream out;
        std::string numbers = timeColumn("Probe");
        for (std::size_t k = 0; k < locations.size(); ++k)
        {
            out << "# Probe " << k << " (" << locations[k][0] << " " << locations[k][1] << " " << locations[k][2]
                << ")\n";
            numbers += sampleColumn(std::to_string(k));
        }
        if (form)
        {
            // No "# Probe": readers of OpenFOAM's files pass over it.
            const bool isDisc = form->shape == FaceForm::Shape::disc;
            out << "# Mean over a face in the wall: " << (isDisc ? "disc of radius " : "square of side ")
                << (isDisc ? form->width / 2 : form->width) << " m\n";
        }
        out << numbers << "\n" << timeColumn("Time") << "\n";
        return out.str();
    }

    std::vector<SensorFace> sensors_;
    SampleFile file_;
};

std::unique_ptr<FunctionObject> makeProbes(const FunctionSetting& setting)
{
    for (const auto& field : setting.dict.words(probes::fields))
    {
        if (field != "p")
        {
            throw unknownName("field", field, setting.dict.placeOf(probes::fields), {"p"});
        }
    }
    return std::make_unique<Probes>(pointsInTank(setting, probes::probeLocations), readFaceForm(setting.dict), setting);
}

} // namespace

namespace choices
{
extern const FunctionObject::Choice probes = {
    "probes", "Pressure at points fixed to the tank, or its mean over sensor faces there, [Pa], in the file p",
    makeProbes, probes::all};
}

} // namespace slosh
