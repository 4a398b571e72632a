// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/NeighbourList.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <array>

namespace slosh
{

namespace
{

/// Points in cell order, component by component, so that the distance test runs over contiguous values.
struct SortedPoints
{
    std::array<std::vector<double>, 3> x;
    std::vector<double> skin;
    std::vector<int> record;

    /// Of particles [first, first + points.size()).
    SortedPoints(
        std::span<const Vec> points, std::span<const double> skins, const std::vector<int>& order, std::ptrdiff_t first
    )
    {
        for (auto& component : x)
        {
            component.resize(order.size());
        }
        skin.resize(order.size());
        record.resize(order.size());
        parallelFor(
            static_cast<std::ptrdiff_t>(order.size()),
            [&](std::ptrdiff_t k)
            {
                const Vec& r = points[order[k]];
                x[0][k] = r[0];
                x[1][k] = r[1];
                x[2][k] = r[2];
                skin[k] = skins[first + order[k]];
                record[k] = static_cast<int>(recordOf(first + order[k]));
            }
        );
    }
};

/// Appends the records of all points nearer to r than reach + their own skin, cells searched as far as `farthest`:
/// first a test over a whole chunk (vectorised), then a compaction without branches.
void appendNear(
    const CellGrid& grid, const SortedPoints& points, const Vec& r, double reach, double farthest, std::vector<int>& row
)
{
    constexpr int chunk = 64;
    std::array<unsigned char, chunk> near{};
    std::array<int, chunk> found;
    grid.forEachRange(
        r, farthest,
        [&](int first, int last)
        {
            for (int start = first; start < last; start += chunk)
            {
                const int n = std::min(chunk, last - start);
                const double* x = points.x[0].data() + start;
                const double* y = points.x[1].data() + start;
                const double* z = points.x[2].data() + start;
                const double* skin = points.skin.data() + start;
                const int* record = points.record.data() + start;
                for (int k = 0; k < n; ++k)
                {
                    const double dx = x[k] - r[0], dy = y[k] - r[1], dz = z[k] - r[2];
                    const double nearer = reach + skin[k];
                    near[k] = dx * dx + dy * dy + dz * dz < nearer * nearer;
                }
                std::size_t size = 0;
                for (int k = 0; k < n; ++k)
                {
                    found[size] = record[k];
                    size += near[k];
                }
                row.insert(row.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(size));
            }
        }
    );
}

} // namespace

void NeighbourList::build(const Particles& particles, double reach, int lanes)
{
    const std::vector<double> none(particles.r.size(), 0.0);
    build(particles, reach, none, lanes);
}

void NeighbourList::build(
    const Particles& particles, double supportRadius, std::span<const double> skins, int lanes, const Visible& visible
)
{
    const double widest = skins.empty() ? 0 : *std::max_element(skins.begin(), skins.end());
    const std::ptrdiff_t nFluid = particles.nFluid;
    const std::ptrdiff_t n = particles.size();
    const std::span<const Vec> all(particles.r);
    const auto fluid = all.first(nFluid);
    const auto wall = all.subspan(nFluid);
    fluidGrid_.build(fluid, supportRadius + 2 * widest);
    wallGrid_.build(wall, supportRadius + 2 * widest);
    const SortedPoints fluidPoints(fluid, skins, fluidGrid_.order(), 0);
    const SortedPoints wallPoints(wall, skins, wallGrid_.order(), nFluid);

    rows_.reset(n, lanes);
    constexpr std::ptrdiff_t block = NeighbourRows::rowsPerBlock;
    const auto collect = [&](std::ptrdiff_t begin, std::ptrdiff_t end)
    {
        std::vector<int> rows;
        std::vector<std::ptrdiff_t> parts, ends; // of the liquid, of the row
        for (std::ptrdiff_t i = begin; i < end; ++i)
        {
            const Vec& r = all[i];
            const double reach = supportRadius + skins[i];
            const std::size_t rowBegin = rows.size();
            const auto hideUnseen = [&](std::size_t from)
            {
                if (visible)
                {
                    rows.erase(
                        std::remove_if(
                            rows.begin() + static_cast<std::ptrdiff_t>(from), rows.end(),
                            [&](int record) { return !visible(i, particleOf(record)); }
                        ),
                        rows.end()
                    );
                }
            };
            appendNear(fluidGrid_, fluidPoints, r, reach, reach + widest, rows);
            if (i < nFluid)
            {
                // A particle finds itself at distance 0; its row does not hold it.
                rows.erase(std::find(rows.begin() + static_cast<std::ptrdiff_t>(rowBegin), rows.end(), recordOf(i)));
            }
            hideUnseen(rowBegin);
            parts.push_back(static_cast<std::ptrdiff_t>(rows.size()));
            if (i < nFluid)
            {
                appendNear(wallGrid_, wallPoints, r, reach, reach + widest, rows);
                hideUnseen(parts.back());
            }
            ends.push_back(static_cast<std::ptrdiff_t>(rows.size()));
        }
        rows_.setBlock(begin / block, rows, parts, ends);
    };
    // Rows of the liquid cost more than those of walls: each thread has its share of both.
    const std::ptrdiff_t liquidBlocks = nFluid / block;
    parallelBlocks(liquidBlocks * block, block, collect);
    parallelBlocks(
        n - liquidBlocks * block, block,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        { collect(liquidBlocks * block + begin, liquidBlocks * block + end); }
    );

    wallsInReach_.clear();
    for (std::ptrdiff_t i = nFluid; i < n; ++i)
    {
        if (row(i).groups > 0)
        {
            wallsInReach_.push_back(static_cast<int>(i));
        }
    }
}

std::size_t NeighbourList::bytes() const
{
    return rows_.bytes() + wallsInReach_.capacity() * sizeof(int) + fluidGrid_.bytes() + wallGrid_.bytes();
}

} // namespace slosh
