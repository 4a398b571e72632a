// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/sortByCell.hpp"

#include "base/parallel.hpp"
#include "neighbours/CellGrid.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

namespace slosh
{

namespace
{

/// A column of this many cells across is swept in z while the records of three of its layers stay in a processor's own
/// cache: 144 cells x 27 particles x 32 B x 3 = 0.4 MB in 3D with the support of 3 dx.
constexpr int cellsAcross = 144;

/// Edges of columns, in cells along x and y: square where the grid is wide both ways.
std::array<int, 2> columnEdges(const std::array<int, 3>& cells)
{
    constexpr int square = 12;
    static_assert(square * square == cellsAcross);
    const int x = std::min(cells[0], std::max(square, cellsAcross / std::max(cells[1], 1)));
    const int y = std::min(cells[1], std::max(square, cellsAcross / std::max(x, 1)));
    return {std::max(x, 1), std::max(y, 1)};
}

/// The grid's order, column after column.
std::vector<int> orderByColumns(const CellGrid& grid, std::span<const Vec> points)
{
    const auto [ex, ey] = columnEdges(grid.cells());
    const int columnsAlongX = (grid.cells()[0] + ex - 1) / ex, columnsAlongY = (grid.cells()[1] + ey - 1) / ey;
    if (columnsAlongX * columnsAlongY <= 1)
    {
        return grid.order();
    }
    std::vector<int> column(points.size());
    parallelFor(static_cast<std::ptrdiff_t>(points.size()),
                [&, ex = ex, ey = ey](std::ptrdiff_t k)
                {
                    const auto cell = grid.cellOf(points[k]);
                    column[k] = cell[1] / ey * columnsAlongX + cell[0] / ex;
                });
    std::vector<int> next(static_cast<std::size_t>(columnsAlongX * columnsAlongY) + 1, 0);
    for (const int c : column)
    {
        ++next[static_cast<std::size_t>(c) + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<int> order(points.size());
    for (const int i : grid.order())
    {
        order[next[column[i]]++] = i;
    }
    return order;
}

} // namespace

void sortByCell(Particles& particles, double cellSize)
{
    const std::ptrdiff_t n = particles.nFluid;
    CellGrid grid;
    grid.build(std::span<const Vec>(particles.r).first(n), cellSize, std::span<const int>(particles.id).first(n));
    const std::vector<int> order = orderByColumns(grid, std::span<const Vec>(particles.r).first(n));
    const auto reorder = [&](auto& values)
    {
        auto sorted = values;
        parallelFor(particles.nFluid, [&](std::ptrdiff_t k) { sorted[k] = values[order[k]]; });
        values.swap(sorted);
    };
    reorder(particles.r);
    reorder(particles.v);
    reorder(particles.rho);
    reorder(particles.p);
    reorder(particles.id);
    if (!particles.meanDiffusion.empty())
    {
        reorder(particles.meanDiffusion);
    }
}

} // namespace slosh
