// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "fluid/FluidProperties.hpp"
#include "kernels/Kernel.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "sampling/Snapshot.hpp"

#include <memory>
#include <string>
#include <vector>

namespace slosh
{

/// What constant/ says, read once: the solver and probeSample work on the same.
class CaseScene
{
public:
    /// `particleSpacing` as the particles' time directory has it, `wallSuction` as system/sphSchemes has it. Throws
    /// CaseError.
    CaseScene(const Case& theCase, double particleSpacing, bool wallSuction);

    const Tank& tank() const { return tank_; }
    const Kernel& kernel() const { return kernel_; }
    const FluidProperties& fluid() const { return fluid_; }
    const SolidBodyMotion& motion() const { return *motion_; }
    const TaitEquation& equationOfState() const { return scene_.equationOfState; }
    const Scene& scene() const { return scene_; }

    CaseScene(const CaseScene&) = delete; // scene_ refers to members
    CaseScene& operator=(const CaseScene&) = delete;

private:
    Tank tank_;
    Kernel kernel_;
    FluidProperties fluid_;
    std::unique_ptr<SolidBodyMotion> motion_;
    Scene scene_;
};

} // namespace slosh
