#pragma once

#include "base/Vec.hpp"
#include "neighbours/CellGrid.hpp"
#include "particles/Particles.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace slosh
{

/// Verlet lists: for each liquid particle all particles (liquid and wall), for each wall particle all liquid particles,
/// nearer than supportRadius + skin when the list was built, itself left out. They hold every pair within the support
/// until two particles have come nearer by more than the skin.
///
/// Full rows: a pair stands in both rows, so each row's sum has its own fixed order and no thread writes to another's
/// particle. A row's entries are padded to a multiple of `lanes` with the index of a particle that is nowhere near
/// (Particles::size(): one beyond the last), so that a loop over whole vectors needs no mask.
class NeighbourList
{
public:
    /// `reach` = supportRadius + skin, [m].
    void build(const Particles& particles, double reach, int lanes);

    struct Row
    {
        const int* begin;
        const int* end; ///< padded: end - begin is a multiple of lanes
    };

    /// The row of particle i: liquid [0, nFluid), wall [nFluid, nFluid + nWall).
    Row row(std::ptrdiff_t i) const
    {
        const auto k = static_cast<std::size_t>(i);
        return {neighbours_.data() + start_[k], neighbours_.data() + start_[k + 1]};
    }

    /// Wall particles (indices into Particles) that have liquid in reach: the others need not be looked at.
    const std::vector<int>& wallsInReach() const { return wallsInReach_; }

    std::size_t pairs() const { return neighbours_.size(); } ///< padded
    std::size_t bytes() const;

private:
    std::vector<std::ptrdiff_t> start_;
    std::vector<int> neighbours_;
    std::vector<int> wallsInReach_;
    CellGrid fluidGrid_, wallGrid_;
};

} // namespace slosh
