// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <utility>
#include <vector>

namespace slosh
{

struct DrawnSection;

/// The edges of a shape, to be drawn.
struct Outline
{
    std::vector<Vec> corners;               ///< [m]
    std::vector<std::pair<int, int>> edges; ///< indices of corners
};

/// The section at each of these places along its third axis, [m], and the edges between the first and the others.
Outline outlineOf(const DrawnSection& section, const std::vector<double>& places);

} // namespace slosh
