// SPDX-License-Identifier: GPL-3.0-or-later
// constant, polynomial
#include "motion/function1Rows.hpp"

#include "base/pointText.hpp"

#include <cmath>
#include <sstream>

namespace slosh
{

namespace
{

class Constant final : public Function1
{
public:
    Constant(const std::array<double, 3>& value, bool isVector) : value_(value), isVector_(isVector) {}

    Value at(double) const override { return {value_[0], value_[1], value_[2]}; }
    std::optional<double> integral(double t) const override { return value_[0] * t; }
    bool isConstant() const override { return true; }
    std::string description() const override
    {
        std::ostringstream out;
        isVector_ ? out << text(Vec(value_[0], value_[1], value_[2])) : out << value_[0];
        return out.str();
    }

private:
    std::array<double, 3> value_;
    bool isVector_;
};

/// sum_k c_k t^n_k
class Polynomial final : public Function1
{
public:
    explicit Polynomial(std::vector<Function1Row> terms) : terms_(std::move(terms)) {}

    Value at(double t) const override
    {
        Value sum;
        for (const Function1Row& term : terms_)
        {
            const double n = term.argument;
            const Jet power =
                n == 0 ? Jet(1)
                       : Jet(std::pow(t, n), n * std::pow(t, n - 1), n == 1 ? 0 : n * (n - 1) * std::pow(t, n - 2));
            for (std::size_t k = 0; k < sum.size(); ++k)
            {
                sum[k] += term.value[k] * power;
            }
        }
        return sum;
    }
    std::optional<double> integral(double t) const override
    {
        double sum = 0;
        for (const Function1Row& term : terms_)
        {
            sum += term.value[0] * std::pow(t, term.argument + 1) / (term.argument + 1);
        }
        return sum;
    }
    std::string description() const override { return "polynomial of " + std::to_string(terms_.size()) + " terms"; }

private:
    std::vector<Function1Row> terms_; ///< the argument is the exponent
};

std::unique_ptr<Function1> readConstant(const Function1Setting& setting)
{
    const std::span<const Token> tokens = setting.value.empty() ? setting.dict.tokens("value") : setting.value;
    std::size_t at = 0;
    const auto value = function1Value(tokens, at, setting.isVector);
    if (!value || at != tokens.size())
    {
        throw setting.error(std::string("is not a constant ") + (setting.isVector ? "(x y z)" : "number"));
    }
    return constantFunction(*value, setting.isVector);
}

/// ((c n) ...), OpenFOAM's order.
std::unique_ptr<Function1> readPolynomial(const Function1Setting& setting)
{
    const std::span<const Token> tokens = setting.value.empty() ? setting.dict.tokens("coeffs") : setting.value;
    const auto pairs = function1Pairs(tokens, setting.isVector, setting.isVector);
    std::vector<Function1Row> terms;
    bool isSound = pairs && !pairs->empty();
    for (std::size_t k = 0; isSound && k < pairs->size(); ++k)
    {
        const auto& [c, n] = (*pairs)[k];
        // OpenFOAM's vector has an exponent for each component; they must be the same here.
        isSound = n[0] >= 0 && (!setting.isVector || (n[0] == n[1] && n[1] == n[2]));
        terms.push_back({n[0], c});
    }
    if (!isSound)
    {
        throw setting.error("is not a polynomial ((coefficient exponent) ...) with exponents >= 0");
    }
    return std::make_unique<Polynomial>(std::move(terms));
}

} // namespace

std::unique_ptr<Function1> constantFunction(const std::array<double, 3>& value, bool isVector)
{
    return std::make_unique<Constant>(value, isVector);
}

namespace choices
{
extern const Function1::Choice constant = {"constant", "A constant value", readConstant};
extern const Function1::Choice polynomial = {"polynomial", "((c n) ...): the sum of all c t^n", readPolynomial};
} // namespace choices

} // namespace slosh
