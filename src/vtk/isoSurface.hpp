// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/LatticeField.hpp"

#include <functional>
#include <vector>

namespace slosh
{

/// A surface of triangles, or in a plane lines through two points or more.
struct Surface
{
    std::vector<Vec> points;  ///< [m]
    std::vector<Vec> normals; ///< of length 1, one a point, to where the field is less; none in a plane
    std::vector<std::vector<std::ptrdiff_t>> cells; ///< indices of points
};

/// Where `field` has the value `value`, linear along the lattice's edges, by VTK's flying edges (Schroeder et al., IEEE
/// LDAV 2015, 33). Kept is the part with inside(X) >= 0. The surface ends where the lattice ends. A lattice with one
/// point in a direction gives lines, joined where they meet; one without values nothing.
Surface isoSurface(const LatticeField& field, double value, const std::function<double(const Vec&)>& inside);

} // namespace slosh
