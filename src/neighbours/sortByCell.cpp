#include "neighbours/sortByCell.hpp"

#include "neighbours/CellGrid.hpp"

#include <algorithm>
#include <span>

namespace slosh
{

void sortByCell(Particles& particles, double cellSize)
{
    const auto n = static_cast<std::size_t>(particles.nFluid);
    CellGrid grid;
    grid.build(std::span<const Vec>(particles.r).first(n), cellSize, std::span<const int>(particles.id).first(n));
    const auto reorder = [&](auto& values)
    {
        auto sorted = values;
        for (std::size_t k = 0; k < n; ++k)
        {
            sorted[k] = values[static_cast<std::size_t>(grid.order()[k])];
        }
        values.swap(sorted);
    };
    reorder(particles.r);
    reorder(particles.v);
    reorder(particles.rho);
    reorder(particles.p);
    reorder(particles.id);
}

} // namespace slosh
