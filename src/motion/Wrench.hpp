// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

namespace slosh
{

/// A force, [N], and its moment about a point, [N m]; or an impulse, [N s], and its moment, [N m s].
struct Wrench
{
    Vec force = Vec::Zero();
    Vec moment = Vec::Zero();

    Wrench& operator+=(const Wrench& other)
    {
        force += other.force;
        moment += other.moment;
        return *this;
    }
    Wrench operator+(const Wrench& other) const { return Wrench(*this) += other; }
    Wrench operator*(double factor) const { return {factor * force, factor * moment}; }
    /// Of the same forces, about a point that stands at `point` from the one before.
    Wrench about(const Vec& point) const { return {force, moment - point.cross(force)}; }
};

} // namespace slosh
