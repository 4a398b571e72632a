// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernels/KernelChoice.hpp"
#include "physics/Interactions.hpp"
#include "physics/PairTerms.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace slosh
{

/// Arithmetic of the pair sums; the state is double either way.
enum class Precision
{
    single,          ///< vectors of float, the default: rates to 2e-5
    doublePrecision, ///< vectors of double
    reference        ///< one pair after the other in double: the code the others are held against
};

/// The space pairs live in.
struct PairGeometry
{
    int dim = 3;
    std::array<int, 3> directions{0, 1, 2}; ///< components of Vec that are not empty, first `dim` of them
    double smoothingLength = 0;             ///< h, [m]

    /// `directions`: those that are not empty.
    static PairGeometry of(const std::vector<int>& directions, double smoothingLength)
    {
        PairGeometry geometry{static_cast<int>(directions.size()), {0, 1, 2}, smoothingLength};
        std::copy(directions.begin(), directions.end(), geometry.directions.begin());
        return geometry;
    }
};

/// The pair sums of a scene, with nothing in them that it does not need: the only place where the choices made in
/// dictionaries become types.
std::unique_ptr<Interactions>
makeInteractions(const PairGeometry& geometry, const KernelChoice& kernel, const PairTerms& terms, Precision precision);

} // namespace slosh
