// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"
#include "motion/SolidBodyMotion.hpp"
#include "motion/Transform.hpp"

#include <sstream>

namespace slosh
{

/// A motion that is given as a formula for its transform; velocities and accelerations follow from that.
class MotionFunction : public SolidBodyMotion
{
public:
    virtual Transform transform(double time) const = 0;
    RigidState at(double time) const override { return transform(time).state(); }
};

/// `omega 4;`, `omega [0 0 -1 0 0 0 0] 4;` or, a Function1 as later OpenFOAM writes it, `omega constant 4;`, [rad/s].
double readOmega(const Dictionary& coeffs);

/// "(0 0 0.31)"
std::string shown(const Vec& x);

// One source each.
std::unique_ptr<MotionFunction> readLinearMotion(const Dictionary& coeffs);
std::unique_ptr<MotionFunction> readOscillatingLinearMotion(const Dictionary& coeffs);
std::unique_ptr<MotionFunction> readRotatingMotion(const Dictionary& coeffs);
std::unique_ptr<MotionFunction> readAxisRotationMotion(const Dictionary& coeffs);
std::unique_ptr<MotionFunction> readOscillatingRotatingMotion(const Dictionary& coeffs);
std::unique_ptr<MotionFunction> readSDA(const Dictionary& coeffs);
std::unique_ptr<MotionFunction> readTabulated6DoFMotion(const Dictionary& coeffs, const std::string& caseFolder);
std::unique_ptr<MotionFunction> readMultiMotion(const Dictionary& coeffs, const std::string& caseFolder);

/// A function by name with its coefficients, from a dictionary that holds solidBodyMotionFunction.
std::unique_ptr<MotionFunction> readMotionFunction(const Dictionary& dict, const std::string& caseFolder);

} // namespace slosh
