#include "neighbours/sortByCell.hpp"

#include "base/parallel.hpp"
#include "neighbours/CellGrid.hpp"

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
        parallelFor(particles.nFluid,
                    [&](std::ptrdiff_t i)
                    {
                        const auto k = static_cast<std::size_t>(i);
                        sorted[k] = values[static_cast<std::size_t>(grid.order()[k])];
                    });
        values.swap(sorted);
    };
    reorder(particles.r);
    reorder(particles.v);
    reorder(particles.rho);
    reorder(particles.p);
    reorder(particles.id);
}

} // namespace slosh
