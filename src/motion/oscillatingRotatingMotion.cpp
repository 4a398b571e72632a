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
    .name = "amplitude", .example = "(8 0 0)", .unit = unit::degree, .sentence = "Euler angles, R = Rx Ry Rz"};
constexpr Key dictionary{
    .name = "oscillatingRotatingMotionCoeffs",
    .sentence = "the tank is turned about origin by amplitude sin(omega t)",
    .entries = [] {
        return Keys{origin, amplitude, omegaKey()};
    }};

} // namespace oscillatingRotatingMotionCoeffs

/// Euler angles amplitude sin(omega t) (deg), R = R_x R_y R_z, about origin. A positive roll turns +y towards +z.
class OscillatingRotatingMotion final : public MotionFunction, public Harmonic
{
public:
    OscillatingRotatingMotion(const Vec& origin, const Vec& amplitude, double omega)
        : origin_(origin), amplitude_(amplitude), omega_(omega)
    {
    }

    Transform transform(double time) const override
    {
        const Vec a = amplitude_ * (std::numbers::pi / 180);
        const Jet s = sin(omega_ * Jet::time(time));
        return Transform::rotationAbout(
            origin_, Transform::eulerXYZ({a[0] * s, a[1] * s, a[2] * s}), Transform::JetVec::Zero()
        );
    }

    double angularFrequency() const override { return omega_; }

    std::string description() const override
    {
        std::ostringstream out;
        out << "oscillatingRotatingMotion: origin " << text(origin_) << ", amplitude " << text(amplitude_)
            << " deg, omega " << omega_ << " rad/s";
        return out.str();
    }

private:
    Vec origin_, amplitude_;
    double omega_;
};

std::unique_ptr<MotionFunction> readOscillatingRotatingMotion(const MotionSetting& setting)
{
    using namespace oscillatingRotatingMotionCoeffs;
    return std::make_unique<OscillatingRotatingMotion>(
        setting.coeffs.vector(origin), setting.coeffs.vector(amplitude), readOmega(setting.coeffs)
    );
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice oscillatingRotatingMotion = {
    "oscillatingRotatingMotion", "Roll, pitch and yaw as a sine of time, [deg]", readOscillatingRotatingMotion,
    [] { return Keys{oscillatingRotatingMotionCoeffs::dictionary}; }};
}

} // namespace slosh
