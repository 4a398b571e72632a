// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/Schemes.hpp"

#include "integration/TimeIntegrator.hpp"

namespace slosh
{

Schemes Schemes::read(const Dictionary& dict)
{
    Schemes schemes;
    dict.allow({"scheme"}); // whose entries stand in `dict`: case/namedSchemes.hpp
    dict.ignore({"wall"});  // scene/Scene.hpp
    schemes.frame = frameNamed(dict.choiceOr("frame", "tank", {"tank", "inertial"}, "frame"));
    schemes.timeIntegration =
        choose(dict, "timeIntegration", TimeIntegrator::choices(), "time integration scheme").name;

    const Dictionary diffusion = dict.dictOr("densityDiffusion");
    diffusion.allow({"delta"});
    schemes.densityDiffusion = choose(diffusion, "type", densityDiffusions(), "density diffusion type").read(diffusion);
    diffusion.refuseUnknown();

    const Dictionary density = dict.dictOr("densityReinitialisation");
    density.allow({"interval"});
    if (density.choice("type", {"MLS", "none"}, "density re-initialisation type") == "MLS")
    {
        schemes.densityInterval = density.labelOr("interval", schemes.densityInterval, atLeast(1));
    }
    else
    {
        schemes.densityInterval = 0;
    }
    density.refuseUnknown();

    const Dictionary damping = dict.dictOr("soundDamping");
    damping.allow({"coefficient", "length"});
    if (damping.choice("type", {"none", "coarse"}, "sound damping type") == "coarse")
    {
        // More makes films and spray noisy: docs/decisions/0029.
        schemes.soundDamping = damping.scalarOr("coefficient", 1, unit::none, Range{0, 1.5, false, true});
        schemes.dampingLength = damping.has("length") ? damping.scalar("length", unit::metre, positive) : 0;
    }
    damping.refuseUnknown();

    const std::string precision = dict.choiceOr("precision", "single", {"single", "double", "reference"}, "precision");
    schemes.precision = precision == "single"   ? Precision::single
                        : precision == "double" ? Precision::doublePrecision
                                                : Precision::reference;

    const Dictionary limits = dict.dictOr("limits");
    schemes.maxDensityDeviation =
        limits.scalarOr("densityDeviation", schemes.maxDensityDeviation, unit::none, Range{0, 1, false, false});
    schemes.maxParticlesOutside = limits.labelOr("particlesOutside", schemes.maxParticlesOutside, notNegative);
    schemes.maxCourantNumber = limits.scalarOr(
        "courantNumber", TimeIntegrator::make(schemes.timeIntegration)->unstableCo(), unit::none, positive
    );
    limits.refuseUnknown();

    dict.refuseUnknown();
    return schemes;
}

const std::vector<Choice<double (*)(const Dictionary&)>>& Schemes::densityDiffusions()
{
    static const std::vector<Choice<double (*)(const Dictionary&)>> table = {
        {"none", "Nothing is added to the continuity equation", [](const Dictionary&) { return 0.0; }},
        {"Fourtakas", "That of Fourtakas et al. (2019), by delta, which leaves liquid at rest alone",
         [](const Dictionary& entries) { return entries.scalarOr("delta", 0.1, unit::none, positive); }}};
    return table;
}

} // namespace slosh
