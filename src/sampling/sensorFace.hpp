// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampling/FunctionObject.hpp"

#include <optional>
#include <vector>

namespace slosh
{

/// The form of a pressure sensor's face.
struct FaceForm
{
    enum class Shape
    {
        disc,
        square
    };
    Shape shape = Shape::disc;
    double width = 0; ///< the disc's diameter, the square's side, [m]
};

/// The face of a pressure sensor, flush with the wall: the mean pressure on it is
///     p = int_A p(X) w dA/int_A w dA,   A: the part of the face that lies on the wall and in the tank,
/// with pressureAt() for p(X): a dry part counts as 0, a part beyond a corner or an edge of the wall does not count.
/// The face lies in the plane through the probe that is parallel to the nearest wall or body (of two equally near the
/// one that Tank::nearestWall names). The sides of a square are horizontal and up the wall; on floors and roofs along x
/// and y. In 3D w = 1. In 2D, where the pressure is the same all along the empty direction, A is the face's width
/// along the wall and w its extent in the empty direction, of a disc the chord at the distance s from its middle:
///     w = 2 sqrt(R^2 - s^2).
///
/// The quadrature is fixed when the face is made: cells of half a particle spacing at most, eight across the face at
/// least, so that a surface that crosses a small face is seen, too. Each cell has one point, the centroid of its part
/// of A, and the share of its part in A: a pressure linear in X is integrated exactly up to how well A is known, which
/// is from samples of 1/256 of the face's width. A kink, as at the surface, costs the square of a cell's width.
class SensorFace
{
public:
    struct Point
    {
        Vec X;        ///< in the tank's coordinates, [m]
        double share; ///< of the mean; all together 1
    };

    /// A sensor without extent: its pressure is pressureAt(X).
    explicit SensorFace(const Vec& X) : points_{{X, 1}} {}
    /// The face around X, which must be at a wall.
    SensorFace(const Tank& tank, const Vec& X, const FaceForm& form, double particleSpacing);

    /// Empty where no part of the face lies on the wall.
    const std::vector<Point>& points() const { return points_; }

    /// Mean over the face, [Pa].
    double pressure(const Snapshot& snapshot) const;

private:
    std::vector<Point> points_;
};

/// The face that a function's probes have: radius of a disc or size of a square. None where neither is set. Throws
/// CaseError where both are, or one that is not > 0.
std::optional<FaceForm> readFaceForm(const Dictionary& dict);
Keys faceFormKeys();

/// The sensors at `locations`, with that face. Throws CaseError for one with a face that is farther from the nearest
/// wall or body than half a particle spacing, or no part of whose face lies on it.
std::vector<SensorFace>
sensorsAt(const std::vector<Vec>& locations, const std::optional<FaceForm>& form, const FunctionSetting& setting);

} // namespace slosh
