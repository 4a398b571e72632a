// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Harmonic.hpp"
#include "motion/MotionFunction.hpp"

#include <numbers>

namespace slosh
{

namespace
{

namespace oscillatingRotatingMotionCoeffs
{

constexpr Key origin{.name = "origin", .example = "(0 0 0.31)", .unit = unit::metre};
constexpr Key amplitude{
    .name = "amplitude",
    .example = "(8 0 0)",
    .unit = unit::degree,
    .sentence = "Euler angles, R = Rx Ry Rz; or a Function1 of time"};
constexpr Key dictionary{
    .name = "oscillatingRotatingMotionCoeffs",
    .sentence = "rotation about origin by amplitude sin(omega t)",
    .entries = [] {
        return joined({origin, amplitude, omegaKey()}, function1Coeffs({"amplitudeCoeffs", "omegaCoeffs"}));
    }};

} // namespace oscillatingRotatingMotionCoeffs

/// Euler angles amplitude sin(omega t) (deg), R = R_x R_y R_z, about origin. A positive roll turns +y towards +z.
class OscillatingRotatingMotion final : public MotionFunction, public Harmonic
{
public:
    explicit OscillatingRotatingMotion(const MotionSetting& setting)
        : origin_(setting.coeffs.vector(oscillatingRotatingMotionCoeffs::origin)),
          amplitude_(setting.vector(oscillatingRotatingMotionCoeffs::amplitude)), omega_(setting.scalar(omegaKey()))
    {
    }

    Transform transform(double time) const override
    {
        const Transform::JetVec a = amplitude_->vectorAt(time) * Jet(std::numbers::pi / 180);
        const Jet s = sin(omega_->scalarAt(time) * Jet::time(time));
        return Transform::rotationAbout(
            origin_, Transform::eulerXYZ({a[0] * s, a[1] * s, a[2] * s}), Transform::JetVec::Zero()
        );
    }

    double lastTime() const override { return lastTimeOf({&amplitude_, &omega_}); }

    std::optional<double> angularFrequency() const override
    {
        return omega_->isConstant() ? std::optional(omega_->scalarAt(0).f) : std::nullopt;
    }

    std::string description() const override
    {
        return "oscillatingRotatingMotion: origin " + text(origin_) + ", amplitude " + amplitude_->description() +
               " deg, omega " + omega_->description() + " rad/s";
    }

private:
    Vec origin_;
    std::unique_ptr<Function1> amplitude_, omega_;
};

std::unique_ptr<MotionFunction> readOscillatingRotatingMotion(const MotionSetting& setting)
{
    return std::make_unique<OscillatingRotatingMotion>(setting);
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice oscillatingRotatingMotion = {
    "oscillatingRotatingMotion", "Sinusoidal roll, pitch and yaw, [deg]", readOscillatingRotatingMotion,
    [] { return Keys{oscillatingRotatingMotionCoeffs::dictionary}; }};
}

} // namespace slosh
