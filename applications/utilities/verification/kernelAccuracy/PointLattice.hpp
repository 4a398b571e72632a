// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "dictionary/Dictionary.hpp"

#include <random>
#include <string>
#include <vector>

namespace slosh
{

/// Points that fill the square or cube [0, L]^dim with the spacing dx, each standing for the volume V = dx^dim, and the
/// smoothing length of the kernels that are summed over them.
struct PointLattice
{
    std::string name;
    int dim = 2;
    double hOverDx = 1.23;
    bool onNodes = true;  ///< at i dx, one of them in the middle where L/dx is even; or in cells' centres, (i + 1/2) dx
    double amplitude = 0; ///< a/dx: each coordinate is moved by a number from [-a, a)
    long seed = 1;
    long samples = 1; ///< how many lattices are drawn; one where nothing moves

    bool perturbed() const { return amplitude > 0; }

    /// lattices { <name> { type regular | perturbed; ... } }. Throws CaseError.
    static PointLattice read(const Dictionary& dict, const std::string& name);
    /// Entries of lattices { }.
    static Keys keys();

    /// The lattice of `cells` spacings along each edge. Numbers of the perturbed one are drawn point by point, x y (z):
    ///   a (2 u - 1) dx,  u = floor(n/2^11)/2^53,  n the next of the 64-bit Mersenne twister,
    /// so that a seed gives the same lattice everywhere.
    std::vector<Vec> points(int cells, double dx, std::mt19937_64& random) const;
};

} // namespace slosh
