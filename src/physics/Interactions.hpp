// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fluid/TaitEquation.hpp"
#include "neighbours/ClusterLists.hpp"
#include "particles/Particles.hpp"
#include "physics/BodyForce.hpp"
#include "physics/Rates.hpp"
#include "physics/WallContact.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace slosh
{

/// What the state of walls follows from, besides the liquid around them (physics/wallState.hpp).
struct WallConditions
{
    BodyForce bodyForce;
    TaitEquation equationOfState; ///< gives rho of p
    bool suction = false;         ///< all may pull
};

/// All that is summed over pairs, with dimension, kernel, terms and precision compiled in: one virtual call per sum
/// instead of a question per pair. Made by makeInteractions.
class Interactions
{
public:
    virtual ~Interactions() = default;

    /// "2D, kernel improvedGaussian, viscosity artificial, density diffusion none, 8 lanes of float"
    virtual std::string description() const = 0;

    /// To be called for every new list: `margin`, how far a particle may move while it holds, [m].
    virtual void listBuilt(const Particles& particles, const ClusterLists& lists, double margin) = 0;
    /// To be called when walls have moved since.
    virtual void wallsMoved(const Particles& particles, const ClusterLists& lists) = 0;

    /// Sets p of the liquid particles [begin, end).
    using SetPressure = std::function<void(std::ptrdiff_t begin, std::ptrdiff_t end)>;

    /// Takes in the state that the sums are of: the liquid's r, v, rho and p, which it has set where there is a
    /// `setPressure` (the liquid must be sorted then), and from these what walls in reach show (physics/wallState.hpp),
    /// whose p and rho it sets. `contact`: by wall particle, filled for the walls in reach where it is not empty; those
    /// that are `enclosed` in it may pull, too.
    virtual void
    see(const ClusterLists& lists, const WallConditions& conditions, const SetPressure& setPressure,
        Particles& particles, std::vector<WallContact>& contact) = 0;

    // The sums, of what was seen last.

    /// The right-hand sides of the liquid, Cao et al. 2014, Eq. 1.
    virtual void rates(
        Wanted wanted, const ClusterLists& lists, const Particles& particles, const BodyForce& bodyForce, Rates& rates
    ) const = 0;
    /// Of these what viscosity adds to the acceleration, and what the pressure between liquid and walls adds to both:
    /// physics/budgetParts.hpp. `viscous` stays as it is where it is empty or `wallsAlone` are asked for.
    virtual void budgetParts(
        bool wallsAlone, const ClusterLists& lists, const Particles& particles, std::vector<Vec>& viscous, Rates& walls
    ) const = 0;
    /// physics/movingLeastSquares.hpp
    virtual void
    movingLeastSquares(const ClusterLists& lists, const Particles& particles, std::vector<double>& rho) const = 0;

    virtual std::size_t bytes() const = 0; ///< of the records
};

} // namespace slosh
