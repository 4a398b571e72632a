// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointLattice.hpp"

#include <cmath>

namespace slosh
{

namespace
{

namespace lattices
{

constexpr Key amplitude{
    .name = "amplitude",
    .example = "0.1",
    .range = {0, 0.5, false, true},
    .sentence = "over dx: largest offset of a point in each direction, uniformly distributed"};
constexpr Key seed{
    .name = "seed", .otherwise = "1", .range = between(0, 1e9), .sentence = "equal seeds give equal lattices"};
constexpr Key samples{
    .name = "samples", .otherwise = "1000", .range = between(2, 1e6), .sentence = "number of lattices"};

constexpr Key type{
    .name = "type",
    .example = "perturbed",
    .options = []
    {
        return Options{{"regular"}, {"perturbed", "means and standard deviations over many lattices", [] {
                                         return Keys{amplitude, seed, samples};
                                     }}};
    }};
constexpr Key dimension{.name = "dimension", .example = "2", .range = between(2, 3)};
constexpr Key hOverDx{
    .name = "hOverDx",
    .leftOut = "1.23 in 2D, 1 in 3D",
    .example = "1.23",
    .range = between(0.9, 4),
    .sentence = "smoothing length over dx, h/dx"};
constexpr Key points{
    .name = "points", .otherwise = "nodes", .options = [] {
        return Options{{"nodes", "at 0, dx, 2 dx ..."}, {"cellCentres", "at dx/2, 3 dx/2 ..., as in a filled tank"}};
    }};

constexpr Key perturbed2D{
    .name = "perturbed2D",
    .entries =
        [] {
            return Keys{type, dimension, hOverDx, points};
        },
    .anyName = true};
constexpr Key regular2D{
    .name = "regular2D",
    .entries =
        []
    {
        return Keys{
            {.name = "type", .example = "regular"},
            {.name = "dimension", .example = "2"},
            {.name = "hOverDx", .example = "1.23"},
            {.name = "points", .example = "nodes"}};
    },
    .anyName = true};

} // namespace lattices

} // namespace

Keys PointLattice::keys()
{
    return {lattices::perturbed2D, lattices::regular2D};
}

PointLattice PointLattice::read(const Dictionary& dict, const std::string& name)
{
    PointLattice lattice;
    lattice.name = name;
    const bool perturbed = dict.choice(lattices::type, "lattice type") == "perturbed";
    lattice.dim = static_cast<int>(dict.label(lattices::dimension));
    lattice.hOverDx = dict.scalarOr(lattices::hOverDx, lattice.dim == 2 ? 1.23 : 1.0);
    lattice.onNodes = dict.choice(lattices::points, "place of the points") == "nodes";
    if (perturbed)
    {
        lattice.amplitude = dict.scalar(lattices::amplitude);
        lattice.seed = dict.label(lattices::seed);
        lattice.samples = dict.label(lattices::samples);
    }
    dict.refuseIdle(lattices::perturbed2D.entries());
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
