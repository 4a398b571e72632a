// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

namespace linearMotionCoeffs
{

constexpr Key velocity{.name = "velocity", .example = "(0.1 0 0)", .unit = unit::velocity};
constexpr Key dictionary{
    .name = "linearMotionCoeffs", .sentence = "translation by velocity t", .entries = [] { return Keys{velocity}; }};

} // namespace linearMotionCoeffs

/// d(t) = velocity t.
class LinearMotion final : public MotionFunction
{
public:
    explicit LinearMotion(const Vec& velocity) : velocity_(velocity) {}

    Transform transform(double time) const override
    {
        const Jet t = Jet::time(time);
        return Transform::translation({velocity_[0] * t, velocity_[1] * t, velocity_[2] * t});
    }

    std::string description() const override { return "linearMotion: velocity " + text(velocity_) + " m/s"; }

private:
    Vec velocity_;
};

std::unique_ptr<MotionFunction> readLinearMotion(const MotionSetting& setting)
{
    return std::make_unique<LinearMotion>(setting.coeffs.vector(linearMotionCoeffs::velocity));
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice linearMotion = {
    "linearMotion", "Translation at a constant velocity, [m/s]", readLinearMotion,
    [] { return Keys{linearMotionCoeffs::dictionary}; }};
}

} // namespace slosh
