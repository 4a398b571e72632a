// SPDX-License-Identifier: GPL-3.0-or-later
// A small tank that moves, and its solver.
#pragma once

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"
#include "solver/Schemes.hpp"
#include "solver/WeaklyCompressible.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slosh
{

inline const char* const tanks[] = {"", "plane xz; "}; // 3D, 2D

/// A tank of 0.2 m x 0.2 m with 0.1 m of liquid, 0.01 m apart, that sways and rolls.
struct Sloshing
{
    Scene scene;

    explicit Sloshing(int dim, const std::string& kernelName = "improvedGaussian", double alpha = 0.03)
        : scene{
              Tank::read(Dictionary::parse(
                  std::string("type box; ") + tanks[dim == 2 ? 1 : 0] +
                      "min (0 0 0); max (0.2 0.1 0.2); fillDepth 0.1;",
                  "constant/tankProperties"
              )),
              Kernel::read(Dictionary::parse("kernel " + kernelName + ";", "constant/kernelProperties"), dim, 0.01),
              SolidBodyMotion::read(
                  Dictionary::parse(
                      "dynamicFvMesh dynamicMotionSolverFvMesh; solidBodyMotionFunction "
                      "oscillatingRotatingMotion; oscillatingRotatingMotionCoeffs { origin (0.1 0.05 0); "
                      "amplitude (0 10 0); omega 8; }",
                      "constant/dynamicMeshDict"
                  ),
                  "."
              ),
              Vec(0, 0, -9.81),
              {1000, 12, 7},
              {}}
    {
        if (alpha > 0)
        {
            scene.viscosity = ArtificialViscosity::of(scene.equationOfState, alpha);
        }
    }

    WeaklyCompressible solver(const Schemes& schemes, const std::function<void(Particles&)>& disturb = {}) const
    {
        Particles particles = fillTank(scene.tank, 0.01, 4, 1000, scene.equationOfState, 9.81, 3.69).particles;
        if (disturb)
        {
            disturb(particles);
        }
        const std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
        TimeState start;
        start.tank = scene.motion->at(0);
        return {scene, schemes, std::move(particles), start, walls};
    }
};

/// Steps from time 0.
inline void advance(WeaklyCompressible& solver, long steps, double dt = 2e-4)
{
    for (long n = 0; n < steps; ++n)
    {
        const double t = static_cast<double>(n) * dt;
        solver.updateNeighbours(dt);
        solver.reinitialiseDensity(n);
        solver.beginStep();
        solver.step(t, t + dt);
    }
}

} // namespace slosh
