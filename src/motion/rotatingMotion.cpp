// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

namespace rotatingMotionCoeffs
{

constexpr Key origin{.name = "origin", .example = "(0 0 0)", .unit = unit::metre};
constexpr Key axis{.name = "axis", .example = "(1 0 0)", .sentence = "direction of the axis"};
constexpr Key dictionary{
    .name = "rotatingMotionCoeffs",
    .sentence = "rotation by the integral of omega about the axis through origin",
    .entries = [] {
        return joined({origin, axis, omegaKey()}, function1Coeffs({"omegaCoeffs"}));
    }};

} // namespace rotatingMotionCoeffs

/// By the angle int_0^t omega dt about an axis through origin.
class RotatingMotion final : public MotionFunction
{
public:
    RotatingMotion(const Vec& origin, const Vec& axis, std::unique_ptr<Function1> omega)
        : origin_(origin), axis_(axis), omega_(std::move(omega))
    {
    }

    Transform transform(double time) const override
    {
        const Jet omega = omega_->scalarAt(time);
        const Jet angle(omega_->integral(time).value(), omega.f, omega.d);
        return Transform::rotationAbout(origin_, Transform::rotation(axis_, angle), Transform::JetVec::Zero());
    }

    double lastTime() const override { return omega_->lastTime(); }

    std::string description() const override
    {
        return "rotatingMotion: origin " + text(origin_) + ", axis " + text(axis_) + ", omega " +
               omega_->description() + " rad/s";
    }

private:
    Vec origin_, axis_;
    std::unique_ptr<Function1> omega_;
};

std::unique_ptr<MotionFunction> readRotatingMotion(const MotionSetting& setting)
{
    using namespace rotatingMotionCoeffs;
    const Vec direction = setting.coeffs.vector(axis);
    if (!(direction.norm() > 0))
    {
        throw setting.coeffs.errorAt(axis, "has no direction; expected a vector other than (0 0 0)");
    }
    auto omega = setting.scalar(omegaKey());
    if (!omega->integral(0))
    {
        throw setting.coeffs.errorAt(
            omegaKey(), "is a " + omega->description() +
                            ", which cannot be integrated; expected a constant, a table, a polynomial, a wave or a ramp"
        );
    }
    return std::make_unique<RotatingMotion>(setting.coeffs.vector(origin), direction, std::move(omega));
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice rotatingMotion = {
    "rotatingMotion", "Rotation about an axis at the rate omega, [rad/s]", readRotatingMotion,
    [] { return Keys{rotatingMotionCoeffs::dictionary}; }};
}

} // namespace slosh
