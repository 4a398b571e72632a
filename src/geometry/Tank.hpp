// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "geometry/Fill.hpp"
#include "geometry/Shape.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slosh
{

class Dictionary;

/// The nearest surface that liquid can touch, its normal into the liquid.
struct NearestWall : NearestSurface
{
    std::size_t part = 0; ///< 0: of the tank's walls, k + 1: of its body k
};

/// The tank as constant/tankProperties describes it, in tank coordinates (z up, x surge, y sway): walls of any shape
/// and bodies of any shape in them.
class Tank
{
public:
    /// Throws CaseError: missing or bad entries, two fills or none, fill above the roof, a body outside the tank, two
    /// bodies whose bounds overlap.
    static Tank read(const Dictionary& tankProperties);
    Tank(std::shared_ptr<const Shape> walls, Shapes bodies, Fill fill);

    int dim() const { return emptyDirection_ < 0 ? 3 : 2; }
    int emptyDirection() const { return emptyDirection_; } ///< 0 x, 1 y; -1 in 3D
    /// The directions that are not empty, vertical last: {1, 2} in the yz plane.
    const std::vector<int>& directions() const { return walls_->directions(); }
    const Shape& walls() const { return *walls_; }  ///< the tank's inside
    const BoundingBox& box() const { return box_; } ///< around the walls, the empty direction's extent included
    bool isBox() const { return isBox_; }           ///< the walls are box()
    double thickness() const; ///< extent of the empty direction, 1 in 3D: mass in kg = 2D mass per metre x thickness
    const Fill& fill() const { return fill_; }
    /// Depth of the liquid: its highest point above the bottom, [m].
    double fillDepth() const { return fill_.level() - box_.min().z(); }
    const Shapes& bodies() const { return bodies_; }
    std::size_t parts() const { return bodies_.size() + 1; } ///< that can bear a load: the walls, each body
    /// Of these, as NearestWall::part counts: "walls", and the bodies by their names.
    std::vector<std::string> partNames() const;

    /// Whether X is neither behind a wall nor in a body; cheap, for loops over all particles.
    bool isInside(const Vec& X) const
    {
        return ((X - low_).array() >= 0).all() && ((high_ - X).array() >= 0).all() && (isBox_ || walls_->contains(X)) &&
               (bodies_.empty() || !inBody(X));
    }
    /// The nearest wall or body: distance, [m], negative inside it; normal into the liquid. The empty direction does
    /// not count.
    NearestWall nearestWall(const Vec& X) const;
    double distanceToWall(const Vec& X) const { return nearestWall(X).distance; }

    /// The lowest and the highest point of the tank on the vertical through X, its z, [m]; in a tank that is not convex
    /// the walls between them do not count. Both box().min() where the line misses the tank.
    std::pair<double, double> verticalExtent(const Vec& X) const;

    /// The mean over the liquid at rest, bodies not counted, of a smooth function of the depth below the surface, [m].
    double meanOverDepth(const std::function<double(double)>& f) const;

    /// Where the tank has one still surface that is a rectangle: the box under it, down to the lowest point.
    std::optional<BoundingBox> boxUnderSurface() const;
    /// Whether the liquid at rest fills that box: its frequencies are the tank's.
    bool liquidIsBox() const;
    /// omega_n = sqrt(g k tanh(k h)), the lowest `count` of boxUnderSurface(), rad/s, g = |g|; 3D: kappa = pi
    /// sqrt(m^2/L^2 + n^2/B^2). None without such a box.
    std::vector<double> naturalFrequencies(double gravity, int count) const;

private:
    bool inBody(const Vec& X) const;
    std::shared_ptr<const Shape> walls_;
    bool isBox_;
    int emptyDirection_;
    BoundingBox box_;
    Vec low_, high_; ///< of the box; in the empty direction infinite
    Shapes bodies_;
    Fill fill_;
};

/// All entries of constant/tankProperties.
Keys tankPropertiesKeys();

} // namespace slosh
