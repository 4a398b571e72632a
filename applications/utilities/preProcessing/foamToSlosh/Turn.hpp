// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <optional>
#include <string>

namespace slosh
{

/// A turn of the axes by right angles, after which gravity points along -z, which is down here:
///   X = R X0,   X0 of theirs, X of ours.
struct Turn
{
    Mat R = Mat::Identity(); ///< of 0, 1 and -1, det R = 1

    /// Of gravity g, [m/s^2], along an axis, either way; none where g is 0. Nothing where it is along no axis.
    static std::optional<Turn> upright(const Vec& g);

    bool isNone() const { return R == Mat::Identity(); }
    Vec operator()(const Vec& X0) const { return R * X0 + Vec::Zero(); } ///< no -0
    BoundingBox operator()(const BoundingBox& box) const;
    /// "x -z y": what our axes are of theirs.
    std::string description() const;
};

} // namespace slosh
