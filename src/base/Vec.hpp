// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace slosh
{

/// A point, velocity, force ...: always three components; a 2D scene has one empty direction.
using Vec = Eigen::Vector3d;

/// A point of a plane: of the section of a tank.
using Vec2 = Eigen::Vector2d;

/// A 3 x 3 matrix: rotation, inertia ...
using Mat = Eigen::Matrix3d;

/// The smallest axis-aligned box around points, [m].
using BoundingBox = Eigen::AlignedBox3d;

} // namespace slosh
