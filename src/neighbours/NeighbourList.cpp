#include "neighbours/NeighbourList.hpp"

#include "base/parallel.hpp"

#include <array>

namespace slosh
{

namespace
{

/// Points in cell order, component by component, so that the distance test runs over contiguous values.
struct SortedPoints
{
    std::array<std::vector<double>, 3> x;

    SortedPoints(std::span<const Vec> points, const std::vector<int>& order)
    {
        for (std::size_t d = 0; d < 3; ++d)
        {
            x[d].resize(order.size());
            for (std::size_t k = 0; k < order.size(); ++k)
            {
                x[d][k] = points[static_cast<std::size_t>(order[k])][static_cast<Eigen::Index>(d)];
            }
        }
    }
};

/// Appends offset + order[k] for all points within reach of r: first a test over a whole chunk (vectorised), then a
/// compaction without branches.
void appendNear(const CellGrid& grid, const SortedPoints& points, const Vec& r, double reach, int offset,
                std::vector<int>& row)
{
    constexpr int chunk = 64;
    std::array<unsigned char, chunk> near{};
    const double reach2 = reach * reach;
    const int* order = grid.order().data();
    grid.forEachRange(r, reach,
                      [&](int first, int last)
                      {
                          for (int start = first; start < last; start += chunk)
                          {
                              const int n = std::min(chunk, last - start);
                              const double* x = points.x[0].data() + start;
                              const double* y = points.x[1].data() + start;
                              const double* z = points.x[2].data() + start;
                              for (int k = 0; k < n; ++k)
                              {
                                  const double dx = x[k] - r[0], dy = y[k] - r[1], dz = z[k] - r[2];
                                  near[static_cast<std::size_t>(k)] = dx * dx + dy * dy + dz * dz < reach2;
                              }
                              std::size_t size = row.size();
                              row.resize(size + static_cast<std::size_t>(n));
                              for (int k = 0; k < n; ++k)
                              {
                                  row[size] = offset + order[start + k];
                                  size += near[static_cast<std::size_t>(k)];
                              }
                              row.resize(size);
                          }
                      });
}

void pad(std::vector<int>& row, std::size_t begin, int lanes, int nowhere)
{
    while ((row.size() - begin) % static_cast<std::size_t>(lanes) != 0)
    {
        row.push_back(nowhere);
    }
}

} // namespace

void NeighbourList::build(const Particles& particles, double reach, int lanes)
{
    const std::ptrdiff_t nFluid = particles.nFluid;
    const std::ptrdiff_t n = particles.size();
    const std::span<const Vec> all(particles.r);
    const auto fluid = all.first(static_cast<std::size_t>(nFluid));
    const auto wall = all.subspan(static_cast<std::size_t>(nFluid));
    fluidGrid_.build(fluid, reach);
    wallGrid_.build(wall, reach);
    const SortedPoints fluidPoints(fluid, fluidGrid_.order());
    const SortedPoints wallPoints(wall, wallGrid_.order());

    // Each block of particles collects its rows by itself; the blocks are then joined in their order.
    constexpr std::ptrdiff_t block = 2 * particlesABlock;
    std::vector<std::vector<int>> blockRows(static_cast<std::size_t>((n + block - 1) / block));
    start_.assign(static_cast<std::size_t>(n) + 1, 0);
    const auto collect = [&](std::ptrdiff_t begin, std::ptrdiff_t end)
    {
        auto& rows = blockRows[static_cast<std::size_t>(begin / block)];
        for (std::ptrdiff_t i = begin; i < end; ++i)
        {
            const Vec& r = all[static_cast<std::size_t>(i)];
            const std::size_t rowBegin = rows.size();
            appendNear(fluidGrid_, fluidPoints, r, reach, 0, rows);
            if (i < nFluid)
            {
                // A particle finds itself at distance 0; its row does not hold it.
                std::size_t kept = rowBegin;
                for (std::size_t k = rowBegin; k < rows.size(); ++k)
                {
                    rows[kept] = rows[k];
                    kept += rows[k] != static_cast<int>(i);
                }
                rows.resize(kept);
                appendNear(wallGrid_, wallPoints, r, reach, static_cast<int>(nFluid), rows);
            }
            pad(rows, rowBegin, lanes, static_cast<int>(n));
            start_[static_cast<std::size_t>(i) + 1] = static_cast<std::ptrdiff_t>(rows.size() - rowBegin);
        }
    };
    // Rows of the liquid cost more than those of walls: each thread has its share of both.
    const std::ptrdiff_t liquidBlocks = nFluid / block;
    parallelBlocks(liquidBlocks * block, block, collect);
    parallelBlocks(n - liquidBlocks * block, block,
                   [&](std::ptrdiff_t begin, std::ptrdiff_t end)
                   { collect(liquidBlocks * block + begin, liquidBlocks * block + end); });

    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
    {
        start_[i + 1] += start_[i];
    }
    neighbours_.resize(static_cast<std::size_t>(start_.back()));
    parallelBlocks(static_cast<std::ptrdiff_t>(blockRows.size()), 1,
                   [&](std::ptrdiff_t k, std::ptrdiff_t)
                   {
                       const auto& rows = blockRows[static_cast<std::size_t>(k)];
                       std::copy(rows.begin(), rows.end(),
                                 neighbours_.begin() + start_[static_cast<std::size_t>(k * block)]);
                   });

    wallsInReach_.clear();
    for (std::ptrdiff_t i = nFluid; i < n; ++i)
    {
        if (const Row r = row(i); r.begin != r.end)
        {
            wallsInReach_.push_back(static_cast<int>(i));
        }
    }
}

std::size_t NeighbourList::bytes() const
{
    return start_.capacity() * sizeof(start_[0]) + neighbours_.capacity() * sizeof(neighbours_[0]) +
           wallsInReach_.capacity() * sizeof(int);
}

} // namespace slosh
