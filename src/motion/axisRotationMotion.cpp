// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include <numbers>

namespace slosh
{

namespace
{

namespace axisRotationMotionCoeffs
{

constexpr Key origin{.name = "origin", .example = "(0 0 0)", .unit = unit::metre};
constexpr Key radialVelocity{
    .name = "radialVelocity", .example = "(30 0 0)", .unit = {{}, "deg/s"}, .sentence = "about each axis"};
constexpr Key dictionary{
    .name = "axisRotationMotionCoeffs",
    .sentence = "rotation by |radialVelocity| t about the axis along radialVelocity through origin",
    .entries = [] {
        return Keys{origin, radialVelocity};
    }};

} // namespace axisRotationMotionCoeffs

/// By the angle |radialVelocity| t about the direction of radialVelocity (deg/s) through origin.
class AxisRotationMotion final : public MotionFunction
{
public:
    AxisRotationMotion(const Vec& origin, const Vec& radialVelocity) : origin_(origin), radialVelocity_(radialVelocity)
    {
    }

    Transform transform(double time) const override
    {
        const double omega = radialVelocity_.norm() * std::numbers::pi / 180;
        return Transform::rotationAbout(
            origin_, Transform::rotation(radialVelocity_, omega * Jet::time(time)), Transform::JetVec::Zero()
        );
    }

    std::string description() const override
    {
        return "axisRotationMotion: origin " + text(origin_) + ", radialVelocity " + text(radialVelocity_) + " deg/s";
    }

private:
    Vec origin_, radialVelocity_;
};

std::unique_ptr<MotionFunction> readAxisRotationMotion(const MotionSetting& setting)
{
    using namespace axisRotationMotionCoeffs;
    const Vec velocity = setting.coeffs.vector(radialVelocity);
    if (!(velocity.norm() > 0))
    {
        throw setting.coeffs.errorAt(radialVelocity, "has no direction; expected a vector other than (0 0 0)");
    }
    return std::make_unique<AxisRotationMotion>(setting.coeffs.vector(origin), velocity);
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice axisRotationMotion = {
    "axisRotationMotion", "Rotation about the axis radialVelocity at the constant rate |radialVelocity|, [deg/s]",
    readAxisRotationMotion, [] { return Keys{axisRotationMotionCoeffs::dictionary}; }};
}

} // namespace slosh
