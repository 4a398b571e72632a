// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Harmonic.hpp"
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

namespace oscillatingLinearMotionCoeffs
{

constexpr Key amplitude{
    .name = "amplitude", .example = "(0.01 0 0)", .unit = unit::metre, .sentence = "a vector, or a Function1 of time"};
constexpr Key phaseShift{
    .name = "phaseShift",
    .otherwise = "0",
    .unit = unit::second,
    .sentence = "from later versions of OpenFOAM; a quarter period turns the sine into a cosine; or a Function1"};
constexpr Key verticalShift{
    .name = "verticalShift",
    .otherwise = "(0 0 0)",
    .unit = unit::metre,
    .sentence = "from later versions of OpenFOAM; in any direction; or a Function1"};
constexpr Key dictionary{
    .name = "oscillatingLinearMotionCoeffs",
    .sentence = "translation by amplitude sin(omega (t + phaseShift)) + verticalShift",
    .entries = []
    {
        return joined(
            {amplitude, omegaKey(), phaseShift, verticalShift},
            function1Coeffs({"amplitudeCoeffs", "omegaCoeffs", "phaseShiftCoeffs", "verticalShiftCoeffs"})
        );
    }};

} // namespace oscillatingLinearMotionCoeffs

/// d(t) = amplitude sin(omega (t + phaseShift)) + verticalShift, each of which may depend on time.
class OscillatingLinearMotion final : public MotionFunction, public Harmonic
{
public:
    explicit OscillatingLinearMotion(const MotionSetting& setting)
        : amplitude_(setting.vector(oscillatingLinearMotionCoeffs::amplitude)), omega_(setting.scalar(omegaKey())),
          phaseShift_(setting.scalar(oscillatingLinearMotionCoeffs::phaseShift)),
          verticalShift_(setting.vector(oscillatingLinearMotionCoeffs::verticalShift))
    {
    }

    Transform transform(double time) const override
    {
        const Jet s = sin(omega_->scalarAt(time) * (Jet::time(time) + phaseShift_->scalarAt(time)));
        const Transform::JetVec amplitude = amplitude_->vectorAt(time), shift = verticalShift_->vectorAt(time);
        return Transform::translation(
            {amplitude[0] * s + shift[0], amplitude[1] * s + shift[1], amplitude[2] * s + shift[2]}
        );
    }

    double lastTime() const override { return lastTimeOf({&amplitude_, &omega_, &phaseShift_, &verticalShift_}); }

    std::optional<double> angularFrequency() const override
    {
        return omega_->isConstant() ? std::optional(omega_->scalarAt(0).f) : std::nullopt;
    }

    std::string description() const override
    {
        const auto shown = [](const std::string& name, const Function1& function, const std::string& unit)
        {
            const Function1::Value at0 = function.at(0);
            const bool isZero = function.isConstant() && at0[0].f == 0 && at0[1].f == 0 && at0[2].f == 0;
            return isZero ? "" : ", " + name + " " + function.description() + unit;
        };
        return "oscillatingLinearMotion: amplitude " + amplitude_->description() + " m, omega " +
               omega_->description() + " rad/s" + shown("phase shift", *phaseShift_, " s") +
               shown("shift", *verticalShift_, " m");
    }

private:
    std::unique_ptr<Function1> amplitude_, omega_, phaseShift_, verticalShift_;
};

std::unique_ptr<MotionFunction> readOscillatingLinearMotion(const MotionSetting& setting)
{
    return std::make_unique<OscillatingLinearMotion>(setting);
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice oscillatingLinearMotion = {
    "oscillatingLinearMotion", "Sinusoidal translation, [m]", readOscillatingLinearMotion,
    [] { return Keys{oscillatingLinearMotionCoeffs::dictionary}; }};
}

} // namespace slosh
