// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Harmonic.hpp"
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

namespace oscillatingLinearMotionCoeffs
{

constexpr Key amplitude{.name = "amplitude", .example = "(0.01 0 0)", .unit = unit::metre};
constexpr Key phaseShift{
    .name = "phaseShift",
    .otherwise = "0",
    .unit = unit::second,
    .sentence = "later OpenFOAM's; a quarter of the period makes the sine a cosine"};
constexpr Key dictionary{
    .name = "oscillatingLinearMotionCoeffs",
    .sentence = "the tank is moved by amplitude sin(omega (t + phaseShift))",
    .entries = [] {
        return Keys{amplitude, omegaKey(), phaseShift};
    }};

} // namespace oscillatingLinearMotionCoeffs

/// d(t) = amplitude sin(omega (t + phaseShift)).
class OscillatingLinearMotion final : public MotionFunction, public Harmonic
{
public:
    OscillatingLinearMotion(const Vec& amplitude, double omega, double phaseShift)
        : amplitude_(amplitude), omega_(omega), phaseShift_(phaseShift)
    {
    }

    Transform transform(double time) const override
    {
        const Jet s = sin(omega_ * (Jet::time(time) + phaseShift_));
        return Transform::translation({amplitude_[0] * s, amplitude_[1] * s, amplitude_[2] * s});
    }

    double angularFrequency() const override { return omega_; }

    std::string description() const override
    {
        std::ostringstream out;
        out << "oscillatingLinearMotion: amplitude " << text(amplitude_) << " m, omega " << omega_ << " rad/s";
        if (phaseShift_ != 0)
        {
            out << ", phase shift " << phaseShift_ << " s";
        }
        return out.str();
    }

private:
    Vec amplitude_;
    double omega_;
    double phaseShift_;
};

std::unique_ptr<MotionFunction> readOscillatingLinearMotion(const MotionSetting& setting)
{
    using namespace oscillatingLinearMotionCoeffs;
    return std::make_unique<OscillatingLinearMotion>(
        setting.coeffs.vector(amplitude), readOmega(setting.coeffs), setting.coeffs.scalar(phaseShift)
    );
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice oscillatingLinearMotion = {
    "oscillatingLinearMotion", "To and fro as a sine of time, [m]", readOscillatingLinearMotion,
    [] { return Keys{oscillatingLinearMotionCoeffs::dictionary}; }};
}

} // namespace slosh
