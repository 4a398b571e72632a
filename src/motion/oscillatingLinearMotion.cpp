#include "motion/MotionFunction.hpp"

namespace slosh
{

namespace
{

/// d(t) = amplitude sin(omega t).
class OscillatingLinearMotion final : public MotionFunction
{
public:
    OscillatingLinearMotion(const Vec& amplitude, double omega) : amplitude_(amplitude), omega_(omega) {}

    Transform transform(double time) const override
    {
        const Jet s = sin(omega_ * Jet::time(time));
        return Transform::translation({amplitude_[0] * s, amplitude_[1] * s, amplitude_[2] * s});
    }

    std::string description() const override
    {
        std::ostringstream text;
        text << "oscillatingLinearMotion: amplitude " << shown(amplitude_) << " m, omega " << omega_ << " rad/s";
        return text.str();
    }

private:
    Vec amplitude_;
    double omega_;
};

} // namespace

std::unique_ptr<MotionFunction> readOscillatingLinearMotion(const Dictionary& coeffs)
{
    return std::make_unique<OscillatingLinearMotion>(coeffs.vector("amplitude", unit::metre), readOmega(coeffs));
}

} // namespace slosh
