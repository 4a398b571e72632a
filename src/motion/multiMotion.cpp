// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/MotionFunction.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

namespace multiMotionCoeffs
{

constexpr Key sway{
    .name = "sway",
    .example = "solidBodyMotionFunction oscillatingLinearMotion; amplitude (0 0.01 0); omega 4;",
    .entries = [] { return Keys(); },
    .anyName = true};
constexpr Key roll{
    .name = "roll",
    .example = "solidBodyMotionFunction oscillatingRotatingMotion; origin (0 0 0.31); amplitude (8 0 0); omega 4;",
    .entries = [] { return Keys(); },
    .anyName = true};
constexpr Key dictionary{
    .name = "multiMotionCoeffs",
    .sentence = "motions, each with a solidBodyMotionFunction; the last one is applied to the tank first",
    .entries = [] {
        return Keys{sway, roll};
    }};

} // namespace multiMotionCoeffs

/// T_1 T_2 ...: the last motion is applied to the tank first.
class MultiMotion final : public MotionFunction
{
public:
    explicit MultiMotion(std::vector<std::unique_ptr<MotionFunction>> parts) : parts_(std::move(parts)) {}

    Transform transform(double time) const override
    {
        Transform product = parts_.front()->transform(time);
        for (auto part = parts_.begin() + 1; part != parts_.end(); ++part)
        {
            product = product * (*part)->transform(time);
        }
        return product;
    }

    double lastTime() const override
    {
        double last = parts_.front()->lastTime();
        for (const auto& part : parts_)
        {
            last = std::min(last, part->lastTime());
        }
        return last;
    }

    std::string description() const override
    {
        std::string text = "multiMotion:";
        for (const auto& part : parts_)
        {
            text += (part == parts_.front() ? " " : "; ") + part->description();
        }
        return text;
    }

private:
    std::vector<std::unique_ptr<MotionFunction>> parts_;
};

std::unique_ptr<MotionFunction> readMultiMotion(const MotionSetting& setting)
{
    std::vector<std::unique_ptr<MotionFunction>> parts;
    for (const auto& key : setting.coeffs.keys())
    {
        if (setting.coeffs.isDict(key))
        {
            parts.push_back(setting.readPart(setting.coeffs.dict(key), setting.caseFolder));
        }
    }
    if (parts.empty())
    {
        throw errorIn(
            placeIn(setting.coeffs.name(), setting.coeffs.line()),
            "multiMotion has no motion; expected dictionaries with a solidBodyMotionFunction each"
        );
    }
    return std::make_unique<MultiMotion>(std::move(parts));
}

} // namespace

namespace choices
{
extern const MotionFunction::Choice multiMotion = {
    "multiMotion", "Several motions; the last one is applied to the tank first", readMultiMotion,
    [] { return Keys{multiMotionCoeffs::dictionary}; }};
}

} // namespace slosh
