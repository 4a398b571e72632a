// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion/SolverFrame.hpp"
#include "particles/Particles.hpp"
#include "physics/AcousticDamper.hpp"
#include "physics/WallContact.hpp"
#include "physics/WallFriction.hpp"
#include "scene/Scene.hpp"

#include <optional>
#include <vector>

namespace slosh
{

/// The tank's wall particles during a run: where they stand, what they see of the liquid, and their friction.
class Walls
{
public:
    /// `inTank`: positions in tank coordinates, in the order of `particles`; `seesLiquid`: contact() is wanted by
    /// others, too.
    Walls(
        const Scene& scene, const Particles& particles, std::vector<Vec> inTank, const SolverFrame& frame,
        bool seesLiquid
    );

    const std::vector<Vec>& inTank() const { return inTank_; }
    /// By wall particle, from 0 at the first; empty where it is not wanted.
    std::vector<WallContact>& contact() { return contact_; }

    /// Puts them where the tank is; whether that changed their places.
    bool move(const SolverFrame& frame, Particles& particles);
    /// For a new list, which holds while no particle moves farther than `margin`, [m]: walls without liquid in reach
    /// have p = 0, rho = rho0 until the next one.
    void listBuilt(Particles& particles, double rho0, double margin);

    bool haveFriction() const { return friction_.has_value(); }
    /// Of the tank as it stands in `frame`, to the liquid's accelerations.
    void addFriction(const Particles& particles, const SolverFrame& frame, std::vector<Vec>& acceleration);
    /// Takes the boundary layers over a step of dt, with what was seen in it.
    void advance(Particles& particles, double dt);

private:
    std::vector<Vec> inTank_;
    std::vector<WallContact> contact_;
    SolverFrame frame_; ///< that they were moved to last
    std::optional<WallFriction> friction_;
    double margin_ = 0;
    bool nearIsOld_ = true; ///< friction's list of particles near walls
};

} // namespace slosh
