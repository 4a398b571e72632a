// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/CaseScene.hpp"

namespace slosh
{

CaseScene::CaseScene(const Case& theCase, double particleSpacing, bool wallSuction)
    : tank_(Tank::read(theCase.dictionary("constant/tankProperties"))),
      kernel_(Kernel::read(theCase.dictionaryIfPresent("constant/kernelProperties"), tank_.dim(), particleSpacing)),
      fluid_(FluidProperties::read(theCase.dictionary("constant/fluidProperties"))),
      motion_(SolidBodyMotion::read(theCase.dictionaryIfPresent("constant/dynamicMeshDict"), theCase.root().string())),
      scene_{tank_, kernel_, theCase.gravity(), {}}
{
    scene_.wallSuction = wallSuction;
    scene_.fluid = fluid_;
    scene_.particleSpacing = particleSpacing;
    scene_.equationOfState = fluid_.equationOfState(tank_, scene_.gravity, *motion_);
}

} // namespace slosh
