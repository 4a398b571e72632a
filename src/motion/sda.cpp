// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include <cmath>
#include <numbers>

namespace slosh
{

namespace
{

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
        : CofG_(coeffs.vector("CofG", unit::metre)), lamda_(coeffs.scalar("lamda", unit::none, positive)),
          rollAmax_(coeffs.scalar("rollAmax", unit::none)), rollAmin_(coeffs.scalar("rollAmin", unit::none)),
          heaveA_(coeffs.scalar("heaveA", unit::metre)), swayA_(coeffs.scalar("swayA", unit::metre)),
          Q_(coeffs.scalar("Q", unit::none, positive)), Tp_(coeffs.scalar("Tp", unit::second, positive)),
          Tpn_(coeffs.scalar("Tpn", unit::second, positive)), dTi_(coeffs.scalar("dTi", unit::second, positive)),
          dTp_(coeffs.scalar("dTp", unit::second))
    {
        if (dTp_ == 0)
        {
            throw coeffs.errorAt("dTp", "is 0: the phase divides by it; a small value keeps the period constant,");
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
    "SDA", "Roll, sway and heave of a ship in a sea whose period changes (ship design analysis)", readSDA};
}

} // namespace slosh
