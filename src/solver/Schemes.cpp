// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/Schemes.hpp"

#include "case/namedSchemes.hpp"
#include "integration/TimeIntegrator.hpp"
#include "scene/Scene.hpp"

namespace slosh
{

namespace
{

namespace sphSchemes
{

constexpr Key frame{
    .name = "frame", .otherwise = "tank", .sentence = "reference frame of the equations", .options = [] {
        return Options{{"tank"}, {"inertial"}};
    }};

constexpr Key timeIntegration{
    .name = "timeIntegration",
    .leftOut = "by scheme: cao2014 predictorCorrector, else positionVerlet",
    .example = "predictorCorrector",
    .options = [] { return optionsOf(TimeIntegrator::choices()); }};

constexpr Key diffusionType{
    .name = "type", .leftOut = "by scheme: cao2014 none, else Fourtakas", .example = "Fourtakas", .options = [] {
        return optionsOf(Schemes::densityDiffusions());
    }};
constexpr Key delta{
    .name = "delta",
    .otherwise = "0.1",
    .range = positive,
    .sentence = "larger values smooth more and damp waves; scheme smallWaves: 0.02"};
constexpr Key densityDiffusion{.name = "densityDiffusion", .sentence = "in the continuity equation", .entries = [] {
                                   return Keys{diffusionType};
                               }};

constexpr Key interval{
    .name = "interval",
    .otherwise = "20",
    .range = atLeast(1),
    .sentence = "number of steps between re-initialisations"};
constexpr Key reinitialisationType{
    .name = "type",
    .leftOut = "by scheme: cao2014 MLS, else none",
    .example = "MLS",
    .options = []
    {
        return Options{
            {"MLS", "moving least squares, Colagrossi & Landrini 2003", [] { return Keys{interval}; }}, {"none"}};
    }};
constexpr Key densityReinitialisation{
    .name = "densityReinitialisation", .entries = [] { return Keys{reinitialisationType}; }};

// More makes films and spray noisy: docs/decisions/0029.
constexpr Key coefficient{
    .name = "coefficient",
    .otherwise = "1",
    .range = Range{0, 1.5, false, true},
    .sentence = "the bulk viscosity is coefficient length c0"};
constexpr Key length{
    .name = "length",
    .leftOut = "a quarter of the depth, at least four spacings",
    .example = "0.04",
    .unit = unit::metre,
    .range = positive,
    .sentence = "cell size of the grid"};
constexpr Key dampingType{
    .name = "type",
    .leftOut = "by scheme: recommended coarse, else none",
    .example = "coarse",
    .options = []
    {
        return Options{
            {"coarse", "bulk viscosity on a grid of cells many particles wide; volume-preserving motion is not damped",
             [] {
                 return Keys{coefficient, length};
             }},
            {"none"}};
    }};
constexpr Key soundDamping{
    .name = "soundDamping", .sentence = "damps sound left by impacts in deep liquid", .entries = [] {
        return Keys{dampingType};
    }};

constexpr Key precision{
    .name = "precision",
    .otherwise = "single",
    .sentence = "of the pair sums; the state is in double precision",
    .options = [] {
        return Options{{"single"}, {"double"}, {"reference", "double, pair by pair"}};
    }};

constexpr Key densityDeviation{
    .name = "densityDeviation",
    .otherwise = "0.3",
    .range = Range{0, 1, false, false},
    .sentence = "max |rho/rho0 - 1|"};
constexpr Key particlesOutside{
    .name = "particlesOutside",
    .otherwise = "0",
    .range = notNegative,
    .sentence = "number of particles outside the tank"};
constexpr Key courantNumber{
    .name = "courantNumber",
    .leftOut = "0.944; 2.24 with positionVerlet (recommended, smallWaves)",
    .example = "0.944",
    .range = positive,
    .sentence =
        "c0 dt/h from maxCo or deltaT; above the default none of the tested kernels is stable (docs/stability.md)"};
constexpr Key limits{.name = "limits", .sentence = "a run that exceeds them stops with an error", .entries = [] {
                         return Keys{densityDeviation, particlesOutside, courantNumber};
                     }};

} // namespace sphSchemes

} // namespace

Keys sphSchemesKeys()
{
    using namespace sphSchemes;
    return {schemeKey(), frame,     timeIntegration, densityDiffusion, densityReinitialisation, soundDamping,
            wallKey(),   precision, limits};
}

Schemes Schemes::read(const Dictionary& dict)
{
    using namespace sphSchemes;
    Schemes schemes;
    dict.ignore({std::string(wallKey().name)}); // scene/Scene.hpp
    schemes.frame = frameNamed(dict.choice(sphSchemes::frame, "frame"));
    schemes.timeIntegration = dict.choice(sphSchemes::timeIntegration, "time integration scheme");

    const Dictionary diffusion = dict.dictOr(sphSchemes::densityDiffusion);
    schemes.densityDiffusion =
        choose(diffusion, diffusionType, densityDiffusions(), "density diffusion type").read(diffusion);
    diffusion.refuseUnknown(sphSchemes::densityDiffusion.entries());

    const Dictionary density = dict.dictOr(densityReinitialisation);
    schemes.densityInterval =
        density.choice(reinitialisationType, "density re-initialisation type") == "MLS" ? density.label(interval) : 0;
    density.refuseUnknown(densityReinitialisation.entries());

    const Dictionary damping = dict.dictOr(sphSchemes::soundDamping);
    if (damping.choice(dampingType, "sound damping type") == "coarse")
    {
        schemes.soundDamping = damping.scalar(coefficient);
        schemes.dampingLength = damping.scalarOr(length, 0);
    }
    damping.refuseUnknown(sphSchemes::soundDamping.entries());

    const std::string precision = dict.choice(sphSchemes::precision, "precision");
    schemes.precision = precision == "single"   ? Precision::single
                        : precision == "double" ? Precision::doublePrecision
                                                : Precision::reference;

    const Dictionary limits = dict.dictOr(sphSchemes::limits);
    schemes.maxDensityDeviation = limits.scalar(densityDeviation);
    schemes.maxParticlesOutside = limits.label(particlesOutside);
    schemes.maxCourantNumber =
        limits.scalarOr(courantNumber, TimeIntegrator::make(schemes.timeIntegration)->unstableCo());
    limits.refuseUnknown(sphSchemes::limits.entries());

    dict.refuseUnknown(sphSchemesKeys());
    return schemes;
}

const std::vector<Choice<double (*)(const Dictionary&)>>& Schemes::densityDiffusions()
{
    static const std::vector<Choice<double (*)(const Dictionary&)>> table = {
        {"none", "No density diffusion", [](const Dictionary&) { return 0.0; }},
        {"Fourtakas",
         "Fourtakas et al. (2019), coefficient delta: smooths the density, except the part due to the tank's body "
         "force, and preserves the volume",
         [](const Dictionary& entries) { return entries.scalar(sphSchemes::delta); },
         [] { return Keys{sphSchemes::delta}; }}};
    return table;
}

} // namespace slosh
