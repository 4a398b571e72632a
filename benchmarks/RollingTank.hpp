// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"
#include "filling/fillTank.hpp"
#include "solver/WeaklyCompressible.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace slosh
{

/// A square tank (in 3D a cube) of 1 m that rolls by 8 degrees with 4 rad/s, `edge` particles along each side, filled
/// to `fill` of its height; c0 = 30 m/s, as in tutorials/rollingTank. Particles of a mixing, disordered flow.
class RollingTank
{
public:
    RollingTank(int dim, int edge, double fill, const KernelChoice& choice, const Schemes& schemes)
        : dx_(1.0 / edge), schemes_(schemes),
          scene_{
              Tank::read(Dictionary::parse(
                  std::string("type box; ") +
                      (dim == 2 ? "plane yz; min (-0.5 -0.5 0); max (0.5 0.5 1); "
                                : "min (-0.5 -0.5 0); max (0.5 0.5 1); ") +
                      "fillDepth " + std::to_string(fill) + ";",
                  "constant/tankProperties"
              )),
              Kernel(choice, dim, hOverDx(dim, choice) * dx_),
              SolidBodyMotion::read(
                  Dictionary::parse(
                      "solidBodyMotionFunction oscillatingRotatingMotion; "
                      "oscillatingRotatingMotionCoeffs { origin (0 0 0.5); amplitude (8 0 0); omega 4; }",
                      "constant/dynamicMeshDict"
                  ),
                  "."
              ),
              Vec(0, 0, -9.81),
              {1000, 30, 7},
              {}}
    {
        scene_.viscosity = ArtificialViscosity::of(scene_.equationOfState, 0.03);
        Particles particles = fillTank(scene_.tank, dx_, 4, 1000, scene_.equationOfState, 9.81, 3).particles;
        std::vector<Vec> walls(particles.r.begin() + particles.nFluid, particles.r.end());
        TimeState start;
        start.tank = scene_.motion->at(0);
        solver_ = std::make_unique<WeaklyCompressible>(scene_, schemes_, std::move(particles), start, walls);
    }
    RollingTank(const RollingTank&) = delete;
    RollingTank& operator=(const RollingTank&) = delete;

    /// Neighbours in bulk: 20 within 2h and 43 within 3h in 2D, 79 and 107 in 3D, as codes choose them.
    static double hOverDx(int dim, const KernelChoice& choice)
    {
        const bool compact = std::visit([](auto k) { return k.supportRatio < 3; }, choice);
        return dim == 2 ? 1.23 : compact ? 1.33 : 1.0;
    }

    void advance(int steps)
    {
        for (int k = 0; k < steps; ++k)
        {
            solver_->updateNeighbours(solver_->longestTimeStep(maxCo));
            solver_->reinitialiseDensity(step_);
            solver_->beginStep();
            const double end = time_ + solver_->stableTimeStep(maxCo);
            solver_->step(time_, end);
            time_ = end;
            ++step_;
        }
    }

    const WeaklyCompressible& solver() const { return *solver_; }
    const Kernel& kernel() const { return scene_.kernel; }

private:
    static constexpr double maxCo = 0.25;

    double dx_;
    Schemes schemes_;
    Scene scene_;
    std::unique_ptr<WeaklyCompressible> solver_;
    double time_ = 0;
    long step_ = 0;
};

} // namespace slosh
