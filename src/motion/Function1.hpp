// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Jet.hpp"
#include "dictionary/Choice.hpp"
#include "motion/Transform.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slosh
{

struct Function1Setting;

/// OpenFOAM's Function1: a number, or a vector, that depends on time, with its first and second derivative.
class Function1
{
public:
    /// The components; of a number the first.
    using Value = std::array<Jet, 3>;

    virtual ~Function1() = default;
    virtual Value at(double t) const = 0;
    Jet scalarAt(double t) const { return at(t)[0]; }
    Transform::JetVec vectorAt(double t) const
    {
        const Value value = at(t);
        return {value[0], value[1], value[2]};
    }
    /// int_0^t of the first component; nothing where its formula is not known.
    virtual std::optional<double> integral(double) const { return std::nullopt; }
    virtual bool isConstant() const { return false; }
    /// It is not defined beyond, [s].
    virtual double lastTime() const { return std::numeric_limits<double>::infinity(); }
    /// "4", "(0.01 0 0)", "table of 3 rows from 0 to 100 s", for a log.
    virtual std::string description() const = 0;

    /// By its name in OpenFOAM; what reads it throws CaseError.
    using Choice = slosh::Choice<std::unique_ptr<Function1> (*)(const Function1Setting&)>;
    static const std::vector<Choice>& choices();
};

/// What a Function1 is read from.
struct Function1Setting
{
    const Dictionary& dict;        ///< that holds its parameters
    const Key& key;                ///< the entry that it is the value of; errors name it
    bool isVector;                 ///< three components, or a number
    const std::string& caseFolder; ///< where files are looked up
    std::span<const Token> value;  ///< what stands behind its name, "table ((0 0) (2 4))"; nothing in other forms

    CaseError error(const std::string& message) const { return dict.errorAt(key, message); }

    /// A parameter that is a Function1 itself, of numbers or, if `isLikeThis`, of what this one is of; `otherwise`, in
    /// each component, where it is left out.
    std::unique_ptr<Function1> part(std::string_view name, double otherwise, bool isLikeThis) const;
};

/// The value of an entry in OpenFOAM's forms:
///     omega 4;    omega constant 4;    omega table ((0 0) (2 4));    omega polynomial ((1 0) (2 1));
///     omega { type sine; frequency 1; ... }    omega sine; omegaCoeffs { frequency 1; ... }
/// Throws CaseError.
std::unique_ptr<Function1>
readFunction1(const Dictionary& dict, const Key& key, bool isVector, const std::string& caseFolder);

/// The least lastTime() of some.
double lastTimeOf(std::initializer_list<const std::unique_ptr<Function1>*> functions);

/// The same value at all times.
std::unique_ptr<Function1> constantFunction(const std::array<double, 3>& value, bool isVector);

} // namespace slosh
