// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neighbours/NeighbourList.hpp"
#include "particles/Particles.hpp"
#include "physics/BodyForce.hpp"
#include "physics/Rates.hpp"
#include "physics/WallContact.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// All that is summed over pairs, with dimension, kernel, terms and precision compiled in: one virtual call per sum
/// instead of a question per pair. Made by makeInteractions.
class Interactions
{
public:
    virtual ~Interactions() = default;

    /// Neighbours a row is evaluated at a time: what NeighbourList::build pads rows to.
    virtual int lanes() const = 0;
    /// "2D, improvedGaussian, artificial viscosity, float x 16"
    virtual std::string description() const = 0;

    /// To be called for every new list: `margin`, how far a particle may move while it holds, [m].
    virtual void listBuilt(const Particles& particles, const NeighbourList& neighbours, double margin) = 0;
    // What the sums see is packed first: walls' positions where they move, the state of the liquid, and once that is
    // there and wallPressure() has been asked, the state of the walls in reach of it.
    virtual void packLiquid(const Particles& particles) = 0;
    virtual void packWallPositions(const Particles& particles, const NeighbourList& neighbours) = 0;
    virtual void packWallFlow(const Particles& particles, const NeighbourList& neighbours) = 0;

    // The sums, of what was packed last. physics/wallPressure.hpp, pairRates.hpp,
    // movingLeastSquares.hpp.
    virtual void wallPressure(const NeighbourList& neighbours, const BodyForce& bodyForce, bool suction,
                              Particles& particles, std::vector<WallContact>& contact) = 0;
    virtual void rates(Wanted wanted, const NeighbourList& neighbours, const Particles& particles,
                       const BodyForce& bodyForce, Rates& rates) const = 0;
    virtual void movingLeastSquares(const NeighbourList& neighbours, const Particles& particles,
                                    std::vector<double>& rho) const = 0;

    virtual std::size_t bytes() const = 0; ///< of the records
};

} // namespace slosh
