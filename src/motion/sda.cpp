// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

namespace SDACoeffs
{

constexpr Unit radian{{}, "rad"};

constexpr Key CofG{.name = "CofG", .example = "(0 0 0)", .unit = unit::metre, .sentence = "centre of roll"};
constexpr Key lamda{
    .name = "lamda",
    .example = "50",
    .range = positive,
    .sentence = "model scale: above 1 lengths are divided by it, and times by its square root"};
constexpr Key rollAmax{
    .name = "rollAmax", .example = "0.22654", .unit = radian, .sentence = "roll amplitude at the period Tpn"};
constexpr Key rollAmin{.name = "rollAmin", .example = "0.10472", .unit = radian, .sentence = "minimum roll amplitude"};
constexpr Key heaveA{.name = "heaveA", .example = "3.79", .unit = unit::metre, .sentence = "heave amplitude"};
constexpr Key swayA{.name = "swayA", .example = "2.34", .unit = unit::metre, .sentence = "sway amplitude"};
constexpr Key Q{.name = "Q", .example = "2", .range = positive, .sentence = "roll damping"};
constexpr Key Tp{
    .name = "Tp", .example = "13.93", .unit = unit::second, .range = positive, .sentence = "period at t = 0"};
constexpr Key Tpn{
    .name = "Tpn",
    .example = "11.93",
    .unit = unit::second,
    .range = positive,
    .sentence = "natural period of the ship"};
constexpr Key dTi{
    .name = "dTi",
    .example = "0.059",
    .unit = unit::second,
    .range = positive,
    .sentence = "time in which the period changes by dTp"};
constexpr Key dTp{
    .name = "dTp",
    .example = "-0.001",
    .unit = unit::second,
    .sentence = "not 0; a small value keeps the period constant"};
constexpr Key dictionary{.name = "SDACoeffs", .sentence = "ship design analysis", .entries = [] {
                             return Keys{CofG, lamda, rollAmax, rollAmin, heaveA, swayA, Q, Tp, Tpn, dTi, dTp};
                         }};

} // namespace SDACoeffs

/// Ship design analysis: roll, sway and heave in a sea whose period grows linearly in time, about CofG. OpenFOAM's SDA:
///   T_i = Tp + dTp t/dTi,  w = 2 pi/T_i,  phase = 2 pi ((Tp/u - 1) + ln u - ln Tp)/r,  r = dTp/dTi, u = Tp + r t
///   roll  = max(rollAmax exp(-(T_i - Tpn)^2/(2 Q)), rollAmin) sin(w t + phase), [rad]
///   sway  = swayA (sin(w t + phase + pi) - sin(phase + pi)),   heave = heaveA (sin(w t + phase + pi/2) - sin(phase +
///   pi/2))
/// With lamda > 1 lengths are divided by lamda, times by sqrt(lamda) (Froude scaling).
class SDA final : public MotionFunction
{
public:
    explicit SDA(const Dictionary& coeffs)
        : CofG_(coeffs.vector(SDACoeffs::CofG)), lamda_(coeffs.scalar(SDACoeffs::lamda)),
          rollAmax_(coeffs.scalar(SDACoeffs::rollAmax)), rollAmin_(coeffs.scalar(SDACoeffs::rollAmin)),
          heaveA_(coeffs.scalar(SDACoeffs::heaveA)), swayA_(coeffs.scalar(SDACoeffs::swayA)),
          Q_(coeffs.scalar(SDACoeffs::Q)), Tp_(coeffs.scalar(SDACoeffs::Tp)), Tpn_(coeffs.scalar(SDACoeffs::Tpn)),
          dTi_(coeffs.scalar(SDACoeffs::dTi)), dTp_(coeffs.scalar(SDACoeffs::dTp))
    {
        if (dTp_ == 0)
        {
            throw coeffs.errorAt(
                SDACoeffs::dTp, "is 0; expected another value (a small one keeps the period constant)"
            );
        }
        if (lamda_ > 1)
        {
            heaveA_ /= lamda_;
            swayA_ /= lamda_;
            for (double* time : {&Tp_, &Tpn_, &dTi_, &dTp_})
            {
                *time /= std::sqrt(lamda_);
            }
        }
    }

    Transform transform(double time) const override
    {
        const double pi = std::numbers::pi;
        const Jet t = Jet::time(time);
        const Jet u = Tp_ + dTp_ / dTi_ * t; // the current period
        const Jet w = 2 * pi / u;
        const Jet phase = 2 * pi * (Tp_ / u - 1 + log(u) - std::log(Tp_)) / (dTp_ / dTi_);
        Jet amplitude = rollAmax_ * exp(-((u - Tpn_) * (u - Tpn_)) / (2 * Q_));
        if (amplitude.f < rollAmin_)
        {
            amplitude = rollAmin_;
        }
        const Jet roll = amplitude * sin(w * t + phase);
        const Jet sway = swayA_ * (sin(w * t + phase + pi) - sin(phase + pi));
        const Jet heave = heaveA_ * (sin(w * t + phase + pi / 2) - sin(phase + pi / 2));
        return Transform::rotationAbout(CofG_, Transform::rotation(Vec::UnitX(), roll), {Jet(0), sway, heave});
    }

    std::string description() const override
    {
        std::ostringstream out;
        out << "SDA: CofG " << text(CofG_) << ", roll up to " << rollAmax_ << " rad, sway " << swayA_ << " m, heave "
            << heaveA_ << " m, period from " << Tp_ << " s";
        return out.str();
    }

private:
    Vec CofG_;
    double lamda_, rollAmax_, rollAmin_, heaveA_, swayA_, Q_, Tp_, Tpn_, dTi_, dTp_;
};

std::unique_ptr<MotionFunction> readSDA(const MotionSetting& setting)
{
    return std::make_unique<SDA>(setting.coeffs);
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice SDA = {
    "SDA", "Roll, sway and heave of a ship in waves of changing period (ship design analysis)", readSDA,
    [] { return Keys{SDACoeffs::dictionary}; }};
}

} // namespace slosh
