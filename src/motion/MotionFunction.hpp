// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/pointText.hpp"
#include "dictionary/Choice.hpp"
#include "motion/Function1.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "motion/Transform.hpp"

#include <sstream>

namespace slosh
{

struct MotionSetting;

/// A motion that is given as a formula for its transform; velocities and accelerations follow from that.
class MotionFunction : public SolidBodyMotion
{
public:
    virtual Transform transform(double time) const = 0;
    RigidState at(double time) const override { return transform(time).state(); }

    /// A motion by its name in OpenFOAM. Its source has the class, what reads its coefficients, which throws CaseError,
    /// and this, with one entry, the dictionary <name>Coeffs; CMakeLists.txt lists it.
    using Choice = slosh::Choice<std::unique_ptr<MotionFunction> (*)(const MotionSetting& setting)>;
    static const std::vector<Choice>& choices();
};

/// What a motion is read from.
struct MotionSetting
{
    const Dictionary& coeffs;
    const std::string& caseFolder; ///< where tables are looked up
    /// Reads a motion that is part of this one, from a dictionary that holds its solidBodyMotionFunction.
    std::unique_ptr<MotionFunction> (*readPart)(const Dictionary& dict, const std::string& caseFolder);

    std::unique_ptr<Function1> scalar(const Key& key) const { return readFunction1(coeffs, key, false, caseFolder); }
    std::unique_ptr<Function1> vector(const Key& key) const { return readFunction1(coeffs, key, true, caseFolder); }
};

// The parameters of motions that later OpenFOAM has as Function1: each is a number or vector, or a function of time.
Key omegaKey(); ///< [rad/s]
/// The dictionaries of their parameters, <name>Coeffs, which stand beside them in one of a Function1's forms.
Keys function1Coeffs(const std::vector<std::string_view>& names);

} // namespace slosh
