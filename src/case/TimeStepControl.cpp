// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/TimeStepControl.hpp"

namespace slosh
{

namespace
{

namespace controlDict
{

constexpr Key adjustTimeStep{
    .name = "adjustTimeStep",
    .otherwise = "no",
    .example = "yes",
    .sentence = "whether the time step is adjusted, or fixed to deltaT"};
constexpr Key deltaT{
    .name = "deltaT",
    .leftOut = "0 if steps are adjusted",
    .example = "1e-4",
    .unit = unit::second,
    .range = positive,
    .sentence = "fixed time step; no effect if steps are adjusted, not even on the first step"};
constexpr Key maxCo{
    .name = "maxCo",
    .otherwise = "0.25",
    .range = positive,
    .sentence =
        "adjusted steps are <= maxCo h/(c0 + max|v|), <= 0.25 sqrt(h/max|a|) and, for a stiff viscosity, <= h/(alpha "
        "c0). If omitted: 0.8 in scheme recommended, 1.4 in smallWaves, but at most 8 c/c0 for c0 > 10 c, c the auto "
        "speed of sound. predictorCorrector is stable up to 0.65, with the cubic spline up to 0.42: docs/stability.md"};
constexpr Key maxDeltaT{
    .name = "maxDeltaT",
    .leftOut = "no limit",
    .example = "1",
    .unit = unit::second,
    .range = positive,
    .sentence = "upper limit of adjusted steps"};

} // namespace controlDict

} // namespace

Keys timeStepKeys()
{
    using namespace controlDict;
    return {adjustTimeStep, deltaT, maxCo, maxDeltaT};
}

TimeStepControl TimeStepControl::read(const Dictionary& dict)
{
    TimeStepControl step;
    step.adjust = dict.flag(controlDict::adjustTimeStep);
    const bool bounded = dict.has(controlDict::maxDeltaT); // asked first: it is not what a missing deltaT meant
    if (step.adjust)
    {
        step.maxCo = dict.scalar(controlDict::maxCo);
        step.maxCoIsDefault = !dict.has(controlDict::maxCo) || dict.isDefault(controlDict::maxCo);
        step.maxDeltaT = bounded ? dict.scalar(controlDict::maxDeltaT) : step.maxDeltaT;
        step.deltaT = dict.scalarOr(controlDict::deltaT, 0);
    }
    else
    {
        step.deltaT = dict.scalar(controlDict::deltaT);
        step.maxDeltaT = step.deltaT;
    }
    return step;
}

} // namespace slosh
