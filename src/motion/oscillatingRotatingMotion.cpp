// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/Harmonic.hpp"
#include "motion/MotionFunction.hpp"

#include <numbers>

namespace slosh
{

namespace
{

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
    return std::make_unique<OscillatingRotatingMotion>(
        setting.coeffs.vector("origin", unit::metre), setting.coeffs.vector("amplitude", unit::degree),
        readOmega(setting.coeffs)
    );
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice oscillatingRotatingMotion = {
    "oscillatingRotatingMotion", "Roll, pitch and yaw as a sine of time, [deg]", readOscillatingRotatingMotion};
}

} // namespace slosh
