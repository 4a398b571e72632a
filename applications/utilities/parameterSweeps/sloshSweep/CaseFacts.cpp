// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseFacts.hpp"

#include "common/TemporaryFolder.hpp"

#include "base/writeFile.hpp"
#include "case/Controls.hpp"
#include "motion/Harmonic.hpp"
#include "scene/Scene.hpp"

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
    const Scene scene = Scene::read(theCase);
    const double gravity = scene.gravity.norm();
    if (gravity > 0 && scene.tank.fill().fromWallToWall())
    {
        facts.naturalFrequencies = scene.tank.naturalFrequencies(gravity, modes);
    }
    if (const auto* harmonic = dynamic_cast<const Harmonic*>(scene.motion.get()))
    {
        facts.omega = std::abs(harmonic->angularFrequency());
    }
    facts.endTime = theCase.dictionary("system/controlDict").scalar(endTimeKey());
    return facts;
}

} // namespace slosh
