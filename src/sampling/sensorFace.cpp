// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/sensorFace.hpp"

#include "sampling/samplePoint.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

namespace face
{

constexpr Key radius{
    .name = "radius",
    .leftOut = "a point",
    .example = "0.0045",
    .unit = unit::metre,
    .range = positive,
    .sentence = "radius of a round sensor face in the wall; the value is the mean over the part of the face on the "
                "wall and in the tank, dry parts as 0; probes must be within half a spacing of a wall or body; in 2D "
                "the weights are the face's chords along the empty direction",
    .alternative = true};
constexpr Key size{
    .name = "size",
    .example = "0.009",
    .unit = unit::metre,
    .range = positive,
    .sentence = "instead of radius: side of a square face, horizontal and up the wall",
    .alternative = true};

} // namespace face

constexpr int leastCells = 8;     // across the face
constexpr int leastSamples = 256; // likewise

/// The plane of a face at a wall, and what of it lies on the wall.
class WallPlane
{
public:
    WallPlane(const Tank& tank, const Vec& X, double particleSpacing) : tank_(tank), X_(X)
    {
        const NearestSurface wall = tank.nearestWall(X);
        // Not on the wall itself, where rounding would decide.
        const double step = 1e-3 * particleSpacing;
        before_ = step * wall.normal;
        behind_ = -(wall.distance + step) * wall.normal;
        const int empty = tank.emptyDirection();
        const bool isLevel = std::abs(wall.normal.z()) > 1 - 1e-9;
        along_ = empty >= 0 ? Vec(Vec::Unit(empty).cross(wall.normal))
                 : isLevel  ? Vec(Vec::UnitX())
                            : Vec(Vec::UnitZ().cross(wall.normal).normalized());
        across_ = empty >= 0 ? Vec(Vec::Zero()) : isLevel ? Vec(Vec::UnitY()) : Vec(wall.normal.cross(along_));
    }

    Vec point(double s, double t) const { return X_ + s * along_ + t * across_; }
    bool isOnWall(const Vec& X) const { return tank_.isInside(X + before_) && !tank_.isInside(X + behind_); }

private:
    const Tank& tank_;
    Vec X_, before_, behind_, along_, across_;
};

/// w at (s, t) from the face's middle.
double weight(const FaceForm& form, int dim, double s, double t)
{
    if (form.shape == FaceForm::Shape::square)
    {
        return 1;
    }
    const double inside = form.width * form.width / 4 - s * s - t * t;
    return inside <= 0 ? 0 : dim == 3 ? 1 : 2 * std::sqrt(inside);
}

} // namespace

SensorFace::SensorFace(const Tank& tank, const Vec& X, const FaceForm& form, double particleSpacing)
{
    const WallPlane plane(tank, X, particleSpacing);
    const bool isPlane = tank.dim() == 3;
    const int cells = std::max(leastCells, static_cast<int>(std::ceil(2 * form.width / particleSpacing)));
    const int samples = std::max(4, (leastSamples + cells - 1) / cells); // across a cell
    const auto place = [&](int cell, int sample)
    { return form.width * ((cell + (sample + 0.5) / samples) / cells - 0.5); };
    double all = 0;
    for (int i = 0; i < cells; ++i)
    {
        for (int j = 0; j < (isPlane ? cells : 1); ++j)
        {
            Vec moment = Vec::Zero();
            double sum = 0;
            for (int k = 0; k < samples; ++k)
            {
                for (int l = 0; l < (isPlane ? samples : 1); ++l)
                {
                    const double s = place(i, k), t = isPlane ? place(j, l) : 0;
                    const double w = weight(form, tank.dim(), s, t);
                    if (const Vec P = plane.point(s, t); w > 0 && plane.isOnWall(P))
                    {
                        moment += w * (P - X);
                        sum += w;
                    }
                }
            }
            if (sum > 0)
            {
                points_.push_back({X + moment / sum, sum});
                all += sum;
            }
        }
    }
    for (Point& point : points_)
    {
        point.share /= all;
    }
}

double SensorFace::pressure(const Snapshot& snapshot) const
{
    double sum = 0;
    for (const Point& point : points_)
    {
        sum += point.share * pressureAt(snapshot, point.X);
    }
    return sum;
}

Keys faceFormKeys()
{
    return {face::radius, face::size};
}

std::optional<FaceForm> readFaceForm(const Dictionary& dict)
{
    const bool isDisc = dict.has(face::radius), isSquare = dict.has(face::size);
    if (isDisc && isSquare)
    {
        throw dict.errorAt(face::size, "and radius are both set; expected one of them: a square or a disc");
    }
    if (isDisc)
    {
        return FaceForm{FaceForm::Shape::disc, 2 * dict.scalar(face::radius)};
    }
    if (isSquare)
    {
        return FaceForm{FaceForm::Shape::square, dict.scalar(face::size)};
    }
    return std::nullopt;
}

std::vector<SensorFace>
sensorsAt(const std::vector<Vec>& locations, const std::optional<FaceForm>& form, const FunctionSetting& setting)
{
    std::vector<SensorFace> sensors;
    for (const Vec& X : locations)
    {
        if (!form)
        {
            sensors.emplace_back(X);
            continue;
        }
        const auto refuse = [&](const std::string& why)
        {
            std::ostringstream message;
            message << "gives probes a face, which must lie on a wall; (" << X[0] << " " << X[1] << " " << X[2] << ") "
                    << why;
            return setting.dict.errorAt(
                form->shape == FaceForm::Shape::disc ? face::radius : face::size, message.str()
            );
        };
        const double spacing = setting.scene.particleSpacing, distance = setting.scene.tank.distanceToWall(X);
        if (distance > spacing / 2)
        {
            std::ostringstream why;
            why << "is " << distance << " m from the nearest one, farther than half a particle spacing of " << spacing
                << " m";
            throw refuse(why.str());
        }
        sensors.emplace_back(setting.scene.tank, X, *form, spacing);
        if (sensors.back().points().empty())
        {
            throw refuse("has no part of the face on it");
        }
    }
    return sensors;
}

} // namespace slosh
