// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

namespace rotatingMotionCoeffs
{

constexpr Key origin{.name = "origin", .example = "(0 0 0)", .unit = unit::metre};
constexpr Key axis{.name = "axis", .example = "(1 0 0)", .sentence = "its direction"};
constexpr Key dictionary{
    .name = "rotatingMotionCoeffs",
    .sentence = "the tank is turned by omega t about the axis through origin",
    .entries = [] {
        return Keys{origin, axis, omegaKey()};
    }};

} // namespace rotatingMotionCoeffs

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
    using namespace rotatingMotionCoeffs;
    const Vec direction = setting.coeffs.vector(axis);
    if (!(direction.norm() > 0))
    {
        throw setting.coeffs.errorAt(axis, "has no direction");
    }
    return std::make_unique<RotatingMotion>(setting.coeffs.vector(origin), direction, readOmega(setting.coeffs));
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice rotatingMotion = {
    "rotatingMotion", "About an axis at the constant rate omega, [rad/s]", readRotatingMotion,
    [] { return Keys{rotatingMotionCoeffs::dictionary}; }};
}

} // namespace slosh
