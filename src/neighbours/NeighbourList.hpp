// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "neighbours/CellGrid.hpp"
#include "neighbours/NeighbourRows.hpp"
#include "particles/Particles.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace slosh
{

/// Verlet lists: for each liquid particle all particles (liquid and wall), for each wall particle all liquid particles,
/// nearer than R + s_i + s_j when the list was built, itself left out. They hold every pair within the support R until
/// a particle has moved by more than its skin s_i (VerletSkin).
///
/// Full rows: a pair stands in both rows, so each row's sum has its own fixed order and no thread writes to another's
/// particle. Rows are padded with a record out of reach of all, so that a loop over whole vectors needs no mask.
class NeighbourList
{
public:
    /// Whether two particles see each other, the same either way: not across a thin plate.
    using Visible = std::function<bool(std::ptrdiff_t, std::ptrdiff_t)>;

    /// All pairs nearer than supportRadius + skins[i] + skins[j], [m], one skin for each particle, that see each other.
    void build(
        const Particles& particles, double supportRadius, std::span<const double> skins, int lanes,
        const Visible& visible = nullptr
    );
    /// All pairs nearer than `reach`.
    void build(const Particles& particles, double reach, int lanes);

    /// The row of particle i: liquid [0, nFluid), wall [nFluid, nFluid + nWall).
    NeighbourRows::Row row(std::ptrdiff_t i) const { return rows_.row(i); }
    /// Its groups that hold walls: they stand after the liquid, which may have a share of the first of them.
    NeighbourRows::Row wallPart(std::ptrdiff_t i) const
    {
        NeighbourRows::Row row = rows_.row(i);
        row.first += row.before;
        row.offset += row.before * rows_.width();
        row.groups -= row.before;
        row.before = 0;
        return row;
    }

    /// Wall particles (indices into Particles) that have liquid in reach: the others need not be looked at.
    const std::vector<int>& wallsInReach() const { return wallsInReach_; }

    std::size_t bytes() const;

private:
    NeighbourRows rows_;
    std::vector<int> wallsInReach_;
    CellGrid fluidGrid_, wallGrid_;
};

} // namespace slosh
