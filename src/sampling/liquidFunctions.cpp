// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that write sums over all liquid: centreOfMass, densityDeviation, extent, semiAxes, particlesOutside.
#include "particles/particlesOutside.hpp"
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"
#include "sampling/liquidState.hpp"

namespace slosh
{

namespace
{

/// One row of numbers an instant, under a header.
class LiquidFunction final : public FunctionObject
{
public:
    using Row = std::function<void(const Snapshot&, SampleFile&)>;

    LiquidFunction(const FunctionSetting& setting, const std::string& file, const std::string& header, Row row)
        : file_(setting.folder / file, header, setting.precision), row_(std::move(row))
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

std::string columns(const std::vector<std::string>& names)
{
    std::string header = timeColumn("Time");
    for (const auto& name : names)
    {
        header += sampleColumn(name);
    }
    return header + "\n";
}

} // namespace

std::unique_ptr<FunctionObject> makeCentreOfMass(const FunctionSetting& setting)
{
    return std::make_unique<LiquidFunction>(
        setting, "centreOfMass.dat",
        "# Centre of mass in the tank, in the inertial frame, [m], and its velocity "
        "there, [m/s]\n" +
            columns({"(X Y Z)", "(x y z)", "(u v w)"}),
        [](const Snapshot& snapshot, SampleFile& file)
        {
            const LiquidState liquid = liquidState(snapshot);
            file.add(liquid.centreInTank);
            file.add(liquid.centre);
            file.add(liquid.velocity);
        });
}

std::unique_ptr<FunctionObject> makeDensityDeviation(const FunctionSetting& setting)
{
    return std::make_unique<LiquidFunction>(
        setting, "densityDeviation.dat", "# |rho/rho0 - 1|: largest and root mean square\n" + columns({"max", "rms"}),
        [](const Snapshot& snapshot, SampleFile& file)
        {
            const LiquidState liquid = liquidState(snapshot);
            file.add(liquid.largestDeviation);
            file.add(liquid.rmsDeviation);
        });
}

std::unique_ptr<FunctionObject> makeExtent(const FunctionSetting& setting)
{
    return std::make_unique<LiquidFunction>(
        setting, "extent.dat",
        "# How far the liquid reaches in the tank, half a spacing beyond its outermost particles: lowest and highest "
        "coordinates, [m]\n" +
            columns({"min(X Y Z)", "max(X Y Z)"}),
        [](const Snapshot& snapshot, SampleFile& file)
        {
            const LiquidState liquid = liquidState(snapshot);
            file.add(liquid.extent.min());
            file.add(liquid.extent.max());
        });
}

std::unique_ptr<FunctionObject> makeSemiAxes(const FunctionSetting& setting)
{
    return std::make_unique<LiquidFunction>(setting, "semiAxes.dat",
                                            "# Semi-axes of the ellipse (2D) or ellipsoid (3D) with the second moments "
                                            "of the liquid, along the tank's axes, "
                                            "[m]\n" +
                                                columns({"(a b c)"}),
                                            [](const Snapshot& snapshot, SampleFile& file)
                                            { file.add(liquidState(snapshot).semiAxes); });
}

std::unique_ptr<FunctionObject> makeParticlesOutside(const FunctionSetting& setting)
{
    return std::make_unique<LiquidFunction>(
        setting, "particlesOutside.dat",
        "# Liquid particles deeper than half a spacing in a wall or a body\n" + columns({"outside", "ofLiquid"}),
        [](const Snapshot& snapshot, SampleFile& file)
        {
            const auto outside = particlesOutside(snapshot.scene().tank, snapshot.particles(), snapshot.frame());
            file.add(static_cast<double>(outside.size()));
            file.add(static_cast<double>(snapshot.particles().nFluid));
        });
}

} // namespace slosh
