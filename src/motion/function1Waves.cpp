// SPDX-License-Identifier: GPL-3.0-or-later
// sine, cosine, square
#include "motion/Function1.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

namespace slosh
{

namespace
{

/// What OpenFOAM's waves have: amplitude(t) wave(frequency(t) (t - t0)) scale(t) + level(t).
class Wave : public Function1
{
public:
    explicit Wave(const Function1Setting& setting)
        : amplitude_(setting.part("amplitude", 1, false)), frequency_(setting.part("frequency", 0, false)),
          scale_(setting.part("scale", 1, true)), level_(setting.part("level", 0, true)),
          t0_(setting.dict.scalarOr("t0", 0, unit::second))
    {
        if (!setting.dict.has("frequency"))
        {
            setting.dict.tokens("frequency"); // says that it is missing
        }
    }

    Value at(double t) const override
    {
        const Jet wave = amplitude_->scalarAt(t) * of(frequency_->scalarAt(t) * (Jet::time(t) - t0_));
        const Value scale = scale_->at(t), level = level_->at(t);
        Value value;
        for (std::size_t k = 0; k < value.size(); ++k)
        {
            value[k] = wave * scale[k] + level[k];
        }
        return value;
    }

    std::optional<double> integral(double t) const override
    {
        const auto level = level_->integral(t);
        if (!amplitude_->isConstant() || !frequency_->isConstant() || !scale_->isConstant() || !level)
        {
            return std::nullopt;
        }
        const double a = amplitude_->scalarAt(0).f * scale_->scalarAt(0).f, f = frequency_->scalarAt(0).f;
        const double wave = f == 0 ? of(0).f * t : (integralOf(f * (t - t0_)) - integralOf(-f * t0_)) / f;
        return a * wave + *level;
    }

    std::string description() const override
    {
        return name() + " of amplitude " + amplitude_->description() + " and frequency " + frequency_->description() +
               " Hz";
    }

protected:
    virtual std::string name() const = 0;
    virtual Jet of(const Jet& periods) const = 0;
    virtual double integralOf(double periods) const = 0; ///< from 0

private:
    std::unique_ptr<Function1> amplitude_, frequency_, scale_, level_;
    double t0_;
};

constexpr double twoPi = 2 * std::numbers::pi;

class Sine final : public Wave
{
    using Wave::Wave;
    std::string name() const override { return "sine"; }
    Jet of(const Jet& x) const override { return sin(twoPi * x); }
    double integralOf(double x) const override { return (1 - std::cos(twoPi * x)) / twoPi; }
};

class Cosine final : public Wave
{
    using Wave::Wave;
    std::string name() const override { return "cosine"; }
    Jet of(const Jet& x) const override { return cos(twoPi * x); }
    double integralOf(double x) const override { return std::sin(twoPi * x) / twoPi; }
};

/// 1 for the share markSpace/(1 + markSpace) of each period, then -1.
class Square final : public Wave
{
public:
    explicit Square(const Function1Setting& setting)
        : Wave(setting), markSpace_(setting.dict.scalarOr("markSpace", 1, unit::none, positive))
    {
    }

private:
    std::string name() const override { return "square wave"; }
    double mark() const { return markSpace_ / (1 + markSpace_); }
    Jet of(const Jet& x) const override { return x.f - std::floor(x.f) < mark() ? 1 : -1; }
    double integralOf(double x) const override
    {
        const double rest = x - std::floor(x);
        return std::floor(x) * (2 * mark() - 1) + (rest < mark() ? rest : 2 * mark() - rest);
    }

    double markSpace_;
};

template <class F>
std::unique_ptr<Function1> read(const Function1Setting& setting)
{
    return std::make_unique<F>(setting);
}

} // namespace

namespace choices
{
extern const Function1::Choice sine = {"sine", "amplitude sin(2 pi frequency (t - t0)) scale + level", read<Sine>};
extern const Function1::Choice cosine = {
    "cosine", "amplitude cos(2 pi frequency (t - t0)) scale + level", read<Cosine>};
extern const Function1::Choice square = {
    "square", "As sine, with 1 for the first markSpace/(1 + markSpace) of a period, then -1", read<Square>};
} // namespace choices

} // namespace slosh
