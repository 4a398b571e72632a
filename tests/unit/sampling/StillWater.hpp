// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampling/Snapshot.hpp"

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"

#include <algorithm>
#include <string>

namespace slosh
{

inline constexpr double g = 9.81, D = 0.3, rho0 = 1000;

inline Tank stillTank(int dim, const std::string& bodies = "")
{
    return Tank::read(Dictionary::parse(
        std::string("type box; ") + (dim == 2 ? "plane xz; " : "") +
            "min (0 0 0); max (0.6 0.2 0.6); fillDepth 0.3; geometry { " + bodies + " }",
        "constant/tankProperties"
    ));
}

inline Kernel kernelOf(const std::string& name, int dim, double dx)
{
    return Kernel::read(Dictionary::parse("kernel " + name + "; hOverDx 1.23;", "constant/kernelProperties"), dim, dx);
}

inline Scene stillScene(Tank tank, const Kernel& kernel)
{
    const TaitEquation equationOfState{rho0, 300, 7};
    return {std::move(tank), kernel, SolidBodyMotion::stationary(), Vec(0, 0, -g), equationOfState, {}};
}

/// Water at rest in a tank of 0.6 m x 0.2 m, 0.3 m deep; nearly incompressible, so that p = rho g d to 1e-4.
struct StillWater
{
    double dx = 0.02;
    Scene scene;
    Particles particles;
    TimeState state;

    explicit StillWater(int dim, const std::string& kernelName = "improvedGaussian", const std::string& bodies = "")
        : scene(stillScene(stillTank(dim, bodies), kernelOf(kernelName, dim, dx))),
          particles(fillTank(scene.tank, dx, 4, rho0, scene.equationOfState, g, 3 * 1.23).particles)
    {
        scene.particleSpacing = dx;
        // The walls' pressure as Eq. 13 gives it in still water: the continuation of the liquid's.
        for (std::ptrdiff_t i = particles.nFluid; i < particles.size(); ++i)
        {
            particles.p[i] = std::max(0.0, rho0 * g * (D - particles.r[i].z()));
            particles.rho[i] = scene.equationOfState.rho(particles.p[i]);
        }
    }
    Snapshot snapshot() const { return {scene, particles, state}; }
};

} // namespace slosh
