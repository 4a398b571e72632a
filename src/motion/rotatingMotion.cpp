// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

/// By the angle omega t about an axis through origin.
class RotatingMotion final : public MotionFunction
{
public:
    RotatingMotion(const Vec& origin, const Vec& axis, double omega) : origin_(origin), axis_(axis), omega_(omega) {}

    Transform transform(double time) const override
    {
        return Transform::rotationAbout(
            origin_, Transform::rotation(axis_, omega_ * Jet::time(time)), Transform::JetVec::Zero()
        );
    }

    std::string description() const override
    {
        std::ostringstream out;
        out << "rotatingMotion: origin " << text(origin_) << ", axis " << text(axis_) << ", omega " << omega_
            << " rad/s";
        return out.str();
    }

private:
    Vec origin_, axis_;
    double omega_;
};

std::unique_ptr<MotionFunction> readRotatingMotion(const MotionSetting& setting)
{
    const Vec axis = setting.coeffs.vector("axis", unit::none);
    if (!(axis.norm() > 0))
    {
        throw setting.coeffs.errorAt("axis", "has no direction");
    }
    return std::make_unique<RotatingMotion>(
        setting.coeffs.vector("origin", unit::metre), axis, readOmega(setting.coeffs)
    );
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice rotatingMotion = {
    "rotatingMotion", "About an axis at the constant rate omega, [rad/s]", readRotatingMotion};
}

} // namespace slosh
