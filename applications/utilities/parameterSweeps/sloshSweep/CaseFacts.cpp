// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseFacts.hpp"

#include "common/TemporaryFolder.hpp"

#include "base/writeFile.hpp"
#include "case/Case.hpp"
#include "case/Controls.hpp"
#include "geometry/Tank.hpp"
#include "motion/Harmonic.hpp"
#include "motion/SolidBodyMotion.hpp"

#include <cmath>

namespace slosh
{

CaseFacts caseFacts(const DictionaryFiles& files, int modes)
{
    const TemporaryFolder folder;
    for (const auto& [file, content] : files)
    {
        writeFile(folder.path() / file, content);
    }
    const Case theCase(folder.path());
    CaseFacts facts;
    const Tank tank = Tank::read(theCase.dictionary("constant/tankProperties"));
    const double gravity = theCase.gravity().norm();
    if (gravity > 0 && tank.fill().fromWallToWall())
    {
        facts.naturalFrequencies = tank.naturalFrequencies(gravity, modes);
    }
    const auto motion =
        SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), folder.path().string());
    const auto* harmonic = dynamic_cast<const Harmonic*>(motion.get());
    if (const auto omega = harmonic != nullptr ? harmonic->angularFrequency() : std::nullopt)
    {
        facts.omega = std::abs(*omega);
    }
    facts.endTime = theCase.dictionary("system/controlDict").scalar(endTimeKey());
    return facts;
}

} // namespace slosh
