// SPDX-License-Identifier: GPL-3.0-or-later
// linearRamp, quadraticRamp, halfCosineRamp, quarterCosineRamp, quarterSineRamp, scale
#include "motion/Function1.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace slosh
{

namespace
{

constexpr double pi = std::numbers::pi;

/// From 0 at `start` to 1 at start + duration, in each component.
struct RampForm
{
    std::string_view name;
    Jet (*of)(const Jet& x);      ///< 0 <= x <= 1
    double (*integral)(double x); ///< from 0
};

class Ramp final : public Function1
{
public:
    Ramp(const Function1Setting& setting, const RampForm& form)
        : form_(form), start_(setting.dict.scalarOr("start", 0, unit::second)),
          duration_(setting.dict.scalar("duration", unit::second, positive))
    {
    }

    Value at(double t) const override
    {
        const Jet x = (Jet::time(t) - start_) / Jet(duration_);
        const Jet ramp = x.f <= 0 ? Jet(0) : x.f >= 1 ? Jet(1) : form_.of(x);
        return {ramp, ramp, ramp};
    }
    std::optional<double> integral(double t) const override { return sinceStart(t) - sinceStart(0); }
    std::string description() const override
    {
        std::ostringstream out;
        out << form_.name << " from " << start_ << " to " << start_ + duration_ << " s";
        return out.str();
    }

private:
    double sinceStart(double t) const
    {
        const double x = (t - start_) / duration_;
        return duration_ * (form_.integral(std::clamp(x, 0.0, 1.0)) + std::max(x - 1, 0.0));
    }

    RampForm form_;
    double start_, duration_;
};

/// The product of two, which OpenFOAM calls scale(t) value(t).
class Scale final : public Function1
{
public:
    explicit Scale(const Function1Setting& setting)
        : scale_(readFunction1(setting.dict, {.name = "scale"}, false, setting.caseFolder)),
          value_(readFunction1(
              setting.dict, {.name = "value", .unit = setting.key.unit}, setting.isVector, setting.caseFolder
          ))
    {
    }

    Value at(double t) const override
    {
        Value value = value_->at(t);
        for (Jet& x : value)
        {
            x *= scale_->scalarAt(t);
        }
        return value;
    }
    std::optional<double> integral(double t) const override
    {
        const Function1& constant = value_->isConstant() ? *value_ : *scale_;
        const auto other = (value_->isConstant() ? *scale_ : *value_).integral(t);
        return constant.isConstant() && other ? std::optional(constant.scalarAt(0).f * *other) : std::nullopt;
    }
    double lastTime() const override { return std::min(scale_->lastTime(), value_->lastTime()); }
    std::string description() const override { return value_->description() + " by " + scale_->description(); }

private:
    std::unique_ptr<Function1> scale_, value_;
};

constexpr RampForm linear = {"linearRamp", [](const Jet& x) { return x; }, [](double x) { return x * x / 2; }};
constexpr RampForm quadratic = {
    "quadraticRamp", [](const Jet& x) { return x * x; }, [](double x) { return x * x * x / 3; }};
constexpr RampForm halfCosine = {
    "halfCosineRamp", [](const Jet& x) { return (1 - cos(pi * x)) / 2; },
    [](double x) { return (x - std::sin(pi * x) / pi) / 2; }};
constexpr RampForm quarterCosine = {
    "quarterCosineRamp", [](const Jet& x) { return 1 - cos(pi / 2 * x); },
    [](double x) { return x - std::sin(pi / 2 * x) * 2 / pi; }};
constexpr RampForm quarterSine = {
    "quarterSineRamp", [](const Jet& x) { return sin(pi / 2 * x); },
    [](double x) { return (1 - std::cos(pi / 2 * x)) * 2 / pi; }};

template <const RampForm& form>
std::unique_ptr<Function1> read(const Function1Setting& setting)
{
    return std::make_unique<Ramp>(setting, form);
}

} // namespace

namespace choices
{
extern const Function1::Choice linearRamp = {
    "linearRamp", "From 0 at `start` to 1 at start + duration, x = (t - start)/duration", read<linear>};
extern const Function1::Choice quadraticRamp = {"quadraticRamp", "As linearRamp, but x^2", read<quadratic>};
extern const Function1::Choice halfCosineRamp = {
    "halfCosineRamp", "As linearRamp, but (1 - cos(pi x))/2", read<halfCosine>};
extern const Function1::Choice quarterCosineRamp = {
    "quarterCosineRamp", "As linearRamp, but 1 - cos(pi x/2)", read<quarterCosine>};
extern const Function1::Choice quarterSineRamp = {
    "quarterSineRamp", "As linearRamp, but sin(pi x/2)", read<quarterSine>};
extern const Function1::Choice scale = {
    "scale", "The product of the functions `scale` (a number) and `value`",
    [](const Function1Setting& setting) -> std::unique_ptr<Function1> { return std::make_unique<Scale>(setting); }};
} // namespace choices

} // namespace slosh
