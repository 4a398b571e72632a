#pragma once

#include "base/Vec.hpp"

#include <memory>
#include <string>
#include <vector>

namespace slosh
{

class Dictionary;

/// A solid body inside the tank; signed distance in tank coordinates.
class Shape
{
public:
    virtual ~Shape() = default;
    /// Distance to the surface, [m]: positive outside the body, negative inside.
    virtual double signedDistance(const Vec& X) const = 0;
    virtual BoundingBox bounds() const = 0;
    virtual std::string name() const = 0;
};

/// The tank as constant/tankProperties describes it, in tank coordinates (z up, x surge, y sway).
///
///     type    box;
///     plane   yz;                       // xz | yz; left out: 3D. The empty direction's extent is the slice's
///     thickness. min     (-0.5 -0.46 0);           // inner corners of the tank, [m] max     ( 0.5  0.46 0.62);
///     fillDepth 0.155;                  // or fillLevel (z of the surface), or fillVolume, [m^3]
///     geometry { baffle { type searchableBox; min (...); max (...); } }
class Tank
{
public:
    /// Throws CaseError: missing or bad entries, two fills or none, fill above the roof, body outside the tank.
    static Tank read(const Dictionary& tankProperties);

    int dim() const { return dim_; }                       ///< 2 or 3
    int emptyDirection() const { return emptyDirection_; } ///< 0 x, 1 y; -1 in 3D
    /// The directions that are not empty, vertical last: {1, 2} in the yz plane.
    const std::vector<int>& directions() const { return directions_; }
    const BoundingBox& box() const { return box_; } ///< inner corners, the empty direction's extent included
    double thickness() const; ///< extent of the empty direction, 1 in 3D: mass in kg = 2D mass per metre x thickness
    double fillLevel() const { return fillLevel_; } ///< z of the still surface, [m]
    double fillDepth() const { return fillLevel_ - box_.min().z(); }
    /// Liquid volume: below fillLevel, outside the bodies, [m^3].
    double fillVolume() const { return fillVolume_; }
    const std::vector<std::shared_ptr<const Shape>>& bodies() const { return bodies_; }

    /// Distance from X to the nearest wall or body, [m]; negative inside a wall or body. The empty direction does not
    /// count.
    double distanceToWall(const Vec& X) const;

    /// omega_n = sqrt(g k tanh(k h)), the lowest `count` of the undisturbed box, rad/s, g = |g|; 3D: kappa = pi
    /// sqrt(m^2/L^2 + n^2/B^2).
    std::vector<double> naturalFrequencies(double gravity, int count) const;

private:
    Tank() = default;
    int dim_ = 3;
    int emptyDirection_ = -1;
    std::vector<int> directions_;
    BoundingBox box_;
    double fillLevel_ = 0;
    double fillVolume_ = 0;
    std::vector<std::shared_ptr<const Shape>> bodies_;
};

} // namespace slosh
