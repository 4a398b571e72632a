// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include <numbers>

namespace slosh
{

namespace
{

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
    const Vec radialVelocity = setting.coeffs.vector("radialVelocity", unit::none);
    if (!(radialVelocity.norm() > 0))
    {
        throw setting.coeffs.errorAt("radialVelocity", "has no direction");
    }
    return std::make_unique<AxisRotationMotion>(setting.coeffs.vector("origin", unit::metre), radialVelocity);
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice axisRotationMotion = {
    "axisRotationMotion", "About the axis radialVelocity at the constant rate that it has, [deg/s]",
    readAxisRotationMotion};
}

} // namespace slosh
