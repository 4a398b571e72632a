// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that write sums over all liquid: centreOfMass, densityDeviation, extent, semiAxes, particlesOutside.
#include "particles/particlesOutside.hpp"
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/liquidState.hpp"

#include <functional>

namespace slosh
{

namespace
{

/// One row of numbers an instant, in <name>.dat, under what they are.
class LiquidFunction final : public FunctionObject
{
public:
    using Row = std::function<void(const Snapshot&, SampleFile&)>;

    LiquidFunction(const FunctionSetting& setting, const Choice& choice, const std::string& header, Row row)
        : file_(setting.folder / (std::string(choice.name) + ".dat"), header, setting.precision), row_(std::move(row))
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        file_.beginRow(snapshot.state().time);
        row_(snapshot, file_);
        file_.endRow();
    }

    std::vector<std::filesystem::path> files() const override { return {file_.path()}; }

private:
    SampleFile file_;
    Row row_;
};

std::unique_ptr<FunctionObject> liquidFunction(
    const FunctionSetting& setting, const FunctionObject::Choice& choice, const std::vector<std::string>& columns,
    LiquidFunction::Row row
)
{
    std::string header = "# " + std::string(choice.sentence) + "\n" + timeColumn("Time");
    for (const auto& name : columns)
    {
        header += sampleColumn(name);
    }
    return std::make_unique<LiquidFunction>(setting, choice, header + "\n", std::move(row));
}

} // namespace

namespace choices
{

extern const FunctionObject::Choice centreOfMass = {
    "centreOfMass", "Centre of mass in the tank and in the inertial frame, [m], and its inertial velocity, [m/s]",
    [](const FunctionSetting& setting)
    {
        return liquidFunction(
            setting, centreOfMass, {"(X Y Z)", "(x y z)", "(u v w)"},
            [](const Snapshot& snapshot, SampleFile& file)
            {
                const LiquidState liquid = liquidState(snapshot);
                file.add(liquid.centreInTank);
                file.add(liquid.centre);
                file.add(liquid.velocity);
            }
        );
    }};

extern const FunctionObject::Choice densityDeviation = {
    "densityDeviation", "Density deviation |rho/rho0 - 1|: maximum and root mean square",
    [](const FunctionSetting& setting)
    {
        return liquidFunction(
            setting, densityDeviation, {"max", "rms"},
            [](const Snapshot& snapshot, SampleFile& file)
            {
                const LiquidState liquid = liquidState(snapshot);
                file.add(liquid.largestDeviation);
                file.add(liquid.rmsDeviation);
            }
        );
    }};

extern const FunctionObject::Choice extent = {
    "extent",
    "Extent of the liquid in the tank (the front of a dam break), to half a spacing beyond the outermost particles: "
    "lowest and highest coordinates, [m]",
    [](const FunctionSetting& setting)
    {
        return liquidFunction(
            setting, extent, {"min(X Y Z)", "max(X Y Z)"},
            [](const Snapshot& snapshot, SampleFile& file)
            {
                const LiquidState liquid = liquidState(snapshot);
                file.add(liquid.extent.min());
                file.add(liquid.extent.max());
            }
        );
    }};

extern const FunctionObject::Choice semiAxes = {
    "semiAxes",
    "Semi-axes of the ellipse (2D) or ellipsoid (3D) with the second moments of the liquid, along the tank's axes, [m]",
    [](const FunctionSetting& setting)
    {
        return liquidFunction(
            setting, semiAxes, {"(a b c)"},
            [](const Snapshot& snapshot, SampleFile& file) { file.add(liquidState(snapshot).semiAxes); }
        );
    }};

extern const FunctionObject::Choice particlesOutside = {
    "particlesOutside",
    "Numbers of liquid particles: those more than half a spacing inside or beyond a wall or a body, and all",
    [](const FunctionSetting& setting)
    {
        return liquidFunction(
            setting, particlesOutside, {"outside", "ofLiquid"},
            [](const Snapshot& snapshot, SampleFile& file)
            {
                const auto outside =
                    slosh::particlesOutside(snapshot.scene().tank, snapshot.particles(), snapshot.frame());
                file.add(static_cast<double>(outside.size()));
                file.add(static_cast<double>(snapshot.particles().nFluid));
            }
        );
    }};

} // namespace choices

} // namespace slosh
