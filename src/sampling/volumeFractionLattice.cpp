// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/volumeFractionLattice.hpp"

#include "base/parallel.hpp"
#include "sampling/liquidState.hpp"
#include "sampling/samplePoint.hpp"

#include <algorithm>
#include <cmath>

namespace slosh
{

namespace
{

/// The lattice without values.
LatticeField latticeAbout(const BoundingBox& liquid, const Tank& tank, double reach, double step)
{
    const BoundingBox& box = tank.box();
    LatticeField lattice{box.center(), Vec::Ones(), {1, 1, 1}, {}};
    for (const int d : tank.directions())
    {
        const double length = box.sizes()[d];
        const int n = static_cast<int>(std::ceil(length / step * (1 - 1e-12)));
        lattice.step[d] = length / n;
        const auto intervalsTo = [&](double X) { return (X - box.min()[d]) / lattice.step[d]; };
        const double first = std::clamp(std::floor(intervalsTo(liquid.min()[d] - reach)), 0.0, n - 1.0);
        const double last = std::clamp(std::ceil(intervalsTo(liquid.max()[d] + reach)), first + 1, 1.0 * n);
        lattice.origin[d] = box.min()[d] + first * lattice.step[d];
        lattice.points[d] = static_cast<int>(last - first) + 1;
    }
    return lattice;
}

} // namespace

LatticeField volumeFractionLattice(const Snapshot& snapshot, double step)
{
    if (snapshot.particles().nFluid == 0)
    {
        return {};
    }
    const Scene& scene = snapshot.scene();
    LatticeField lattice = latticeAbout(liquidState(snapshot).extent, scene.tank, scene.kernel.supportRadius(), step);
    const auto [n0, n1, n2] = lattice.points;
    lattice.values.resize(static_cast<std::size_t>(n0) * static_cast<std::size_t>(n1) * static_cast<std::size_t>(n2));
    volumeFraction(snapshot, lattice.origin); // builds the grids, before threads ask for them
    parallelFor(
        static_cast<std::ptrdiff_t>(lattice.values.size()),
        [&](std::ptrdiff_t i) { lattice.values[i] = static_cast<float>(volumeFraction(snapshot, lattice.point(i))); }
    );
    return lattice;
}

} // namespace slosh
