// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointLattice.hpp"

#include "dictionary/Dictionary.hpp"

#include <cmath>

namespace slosh
{

PointLattice PointLattice::read(const Dictionary& dict, const std::string& name)
{
    PointLattice lattice;
    lattice.name = name;
    const bool perturbed = dict.choice("type", {"regular", "perturbed"}, "lattice type") == "perturbed";
    lattice.dim = static_cast<int>(dict.label("dimension", between(2, 3)));
    lattice.hOverDx = dict.scalarOr("hOverDx", lattice.dim == 2 ? 1.23 : 1.0, unit::none, between(0.9, 4));
    lattice.onNodes = dict.choiceOr("points", "nodes", {"nodes", "cellCentres"}, "place of the points") == "nodes";
    if (perturbed)
    {
        lattice.amplitude = dict.scalar("amplitude", unit::none, {0, 0.5, false, true});
        lattice.seed = dict.labelOr("seed", lattice.seed, between(0, 1e9));
        lattice.samples = dict.labelOr("samples", 1000, between(2, 1e6));
    }
    dict.refuseUnknown();
    return lattice;
}

std::vector<Vec> PointLattice::points(int cells, double dx, std::mt19937_64& random) const
{
    const int n = onNodes ? cells + 1 : cells;
    const double first = onNodes ? 0 : 0.5;
    const auto moved = [&](int i)
    {
        const double u = perturbed() ? std::ldexp(static_cast<double>(random() >> 11), -53) : 0.5;
        return (first + i + amplitude * (2 * u - 1)) * dx;
    };
    std::vector<Vec> points;
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            for (int k = 0; k < (dim == 3 ? n : 1); ++k)
            {
                Vec x = Vec::Zero();
                x[0] = moved(i);
                x[1] = moved(j);
                if (dim == 3)
                {
                    x[2] = moved(k);
                }
                points.push_back(x);
            }
        }
    }
    return points;
}

} // namespace slosh
