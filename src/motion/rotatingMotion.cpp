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
        return Transform::rotationAbout(origin_, Transform::rotation(axis_, omega_ * Jet::time(time)),
                                        Transform::JetVec::Zero());
    }

    std::string description() const override
    {
        std::ostringstream text;
        text << "rotatingMotion: origin " << shown(origin_) << ", axis " << shown(axis_) << ", omega " << omega_
             << " rad/s";
        return text.str();
    }

private:
    Vec origin_, axis_;
    double omega_;
};

} // namespace

std::unique_ptr<MotionFunction> readRotatingMotion(const Dictionary& coeffs)
{
    const Vec axis = coeffs.vector("axis", unit::none);
    if (!(axis.norm() > 0))
    {
        throw coeffs.errorAt("axis", "has no direction");
    }
    return std::make_unique<RotatingMotion>(coeffs.vector("origin", unit::metre), axis, readOmega(coeffs));
}

} // namespace slosh
