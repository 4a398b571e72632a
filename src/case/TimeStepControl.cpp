// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/TimeStepControl.hpp"

namespace slosh
{

TimeStepControl TimeStepControl::read(const Dictionary& controlDict)
{
    TimeStepControl step;
    step.adjust = controlDict.flagOr("adjustTimeStep", false);
    controlDict.allow({"deltaT", "maxCo", "maxDeltaT"});
    if (step.adjust)
    {
        step.maxCo = controlDict.scalarOr("maxCo", step.maxCo, unit::none, positive); // docs/stability.md
        step.maxCoIsDefault = !controlDict.has("maxCo") || controlDict.isDefault("maxCo");
        step.maxDeltaT = controlDict.scalarOr("maxDeltaT", step.maxDeltaT, unit::second, positive);
        step.deltaT = controlDict.scalarOr("deltaT", 0, unit::second, positive);
    }
    else
    {
        step.deltaT = controlDict.scalar("deltaT", unit::second, positive);
        step.maxDeltaT = step.deltaT;
    }
    return step;
}

} // namespace slosh
