// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/expression.hpp"

#include "dictionary/TextCursor.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace slosh
{

namespace
{

using Function = double (*)(const double*);
struct Named
{
    std::size_t arguments;
    Function f;
};

const std::map<std::string, Named, std::less<>>& functions()
{
    static const std::map<std::string, Named, std::less<>> table = {
        {"pi", {0, [](const double*) { return std::numbers::pi; }}},
        {"e", {0, [](const double*) { return std::numbers::e; }}},
        {"degToRad", {1, [](const double* x) { return x[0] * std::numbers::pi / 180; }}},
        {"radToDeg", {1, [](const double* x) { return x[0] * 180 / std::numbers::pi; }}},
        {"sqrt", {1, [](const double* x) { return std::sqrt(x[0]); }}},
        {"cbrt", {1, [](const double* x) { return std::cbrt(x[0]); }}},
        {"exp", {1, [](const double* x) { return std::exp(x[0]); }}},
        {"log", {1, [](const double* x) { return std::log(x[0]); }}},
        {"log10", {1, [](const double* x) { return std::log10(x[0]); }}},
        {"sin", {1, [](const double* x) { return std::sin(x[0]); }}},
        {"cos", {1, [](const double* x) { return std::cos(x[0]); }}},
        {"tan", {1, [](const double* x) { return std::tan(x[0]); }}},
        {"asin", {1, [](const double* x) { return std::asin(x[0]); }}},
        {"acos", {1, [](const double* x) { return std::acos(x[0]); }}},
        {"atan", {1, [](const double* x) { return std::atan(x[0]); }}},
        {"sinh", {1, [](const double* x) { return std::sinh(x[0]); }}},
        {"cosh", {1, [](const double* x) { return std::cosh(x[0]); }}},
        {"tanh", {1, [](const double* x) { return std::tanh(x[0]); }}},
        {"floor", {1, [](const double* x) { return std::floor(x[0]); }}},
        {"ceil", {1, [](const double* x) { return std::ceil(x[0]); }}},
        {"round", {1, [](const double* x) { return std::round(x[0]); }}},
        {"abs", {1, [](const double* x) { return std::abs(x[0]); }}},
        {"fabs", {1, [](const double* x) { return std::abs(x[0]); }}},
        {"mag", {1, [](const double* x) { return std::abs(x[0]); }}},
        {"sqr", {1, [](const double* x) { return x[0] * x[0]; }}},
        {"pow", {2, [](const double* x) { return std::pow(x[0], x[1]); }}},
        {"atan2", {2, [](const double* x) { return std::atan2(x[0], x[1]); }}},
        {"hypot", {2, [](const double* x) { return std::hypot(x[0], x[1]); }}},
        {"min", {2, [](const double* x) { return std::min(x[0], x[1]); }}},
        {"max", {2, [](const double* x) { return std::max(x[0], x[1]); }}}};
    return table;
}

/// C's and OpenFOAM's, without parentheses.
const std::map<std::string, double, std::less<>>& constants()
{
    using namespace std::numbers;
    static const std::map<std::string, double, std::less<>> table = {
        {"M_E", e},
        {"M_LOG2E", log2e},
        {"M_LOG10E", log10e},
        {"M_LN2", ln2},
        {"M_LN10", ln10},
        {"M_PI", pi},
        {"M_PI_2", pi / 2},
        {"M_PI_4", pi / 4},
        {"M_1_PI", inv_pi},
        {"M_2_PI", 2 * inv_pi},
        {"M_2_SQRTPI", 2 * inv_sqrtpi},
        {"M_SQRT2", sqrt2},
        {"M_SQRT1_2", sqrt2 / 2},
        {"constant::mathematical::pi", pi},
        {"constant::mathematical::twoPi", 2 * pi},
        {"constant::mathematical::piByTwo", pi / 2},
        {"constant::mathematical::e", e},
        {"mathematicalConstant::pi", pi}};
    return table;
}

/// Recursive descent: sum -> product -> power -> sign -> primary.
class Expression : TextCursor
{
public:
    Expression(
        std::string_view text, const std::function<double(const std::string&)>& variable,
        const std::map<std::string, double, std::less<>>& names
    )
        : TextCursor(text), variable_(variable), names_(names)
    {
    }

    double value()
    {
        const double x = sum();
        if (peek() != '\0')
        {
            fail("unexpected '" + std::string(text_.substr(at_)) + "' at the end");
        }
        return x;
    }

private:
    [[noreturn]] static void fail(const std::string& why) { throw std::invalid_argument(why); }

    double sum()
    {
        double x = product();
        while (true)
        {
            if (take('+'))
            {
                x += product();
            }
            else if (take('-'))
            {
                x -= product();
            }
            else
            {
                return x;
            }
        }
    }

    double product()
    {
        double x = sign();
        while (true)
        {
            if (take('*'))
            {
                x *= sign();
            }
            else if (take('/'))
            {
                x /= sign();
            }
            else if (take('%'))
            {
                x = std::fmod(x, sign());
            }
            else
            {
                return x;
            }
        }
    }

    double sign()
    {
        if (take('-'))
        {
            return -sign();
        }
        if (take('+'))
        {
            return sign();
        }
        const double x = primary();
        return take('^') ? std::pow(x, sign()) : x;
    }

    double primary()
    {
        if (take('('))
        {
            const double x = sum();
            if (!take(')'))
            {
                fail("a ')' is missing");
            }
            return x;
        }
        const char c = peek();
        if (c == '$')
        {
            return variable_(macroName());
        }
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
        {
            return call();
        }
        double x = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), x);
        if (error != std::errc())
        {
            fail(c == '\0' ? "a value is missing at the end" : "'" + std::string(1, c) + "' is not a value");
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        return x;
    }

    std::string macroName()
    {
        ++at_;
        std::size_t end = at_;
        if (peek() == '{')
        {
            end = text_.find('}', ++at_);
            if (end == std::string_view::npos)
            {
                fail("a '}' is missing");
            }
            const std::string name(text_.substr(at_, end - at_));
            at_ = end + 1;
            return name;
        }
        while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '_' ||
                                      text_[end] == '.' || text_[end] == ':'))
        {
            ++end;
        }
        const std::string name(text_.substr(at_, end - at_));
        at_ = end;
        return name;
    }

    double call()
    {
        std::size_t end = at_;
        while (end < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '_' || text_[end] == ':'))
        {
            ++end;
        }
        std::string name(text_.substr(at_, end - at_));
        for (const std::string_view space : {"Foam::", "std::"})
        {
            name.erase(0, name.starts_with(space) ? space.size() : 0);
        }
        at_ = end;
        if (const auto value = constants().find(name); value != constants().end())
        {
            return value->second;
        }
        if (const auto value = names_.find(name); value != names_.end())
        {
            return value->second;
        }
        const auto found = functions().find(name);
        if (found == functions().end())
        {
            fail("unknown name '" + name + "'");
        }
        std::vector<double> arguments;
        if (!take('('))
        {
            fail("'" + name + "' needs parentheses");
        }
        if (!take(')'))
        {
            do
            {
                arguments.push_back(sum());
            } while (take(','));
            if (!take(')'))
            {
                fail("a ')' is missing after the arguments of '" + name + "'");
            }
        }
        if (arguments.size() != found->second.arguments)
        {
            fail(
                "'" + name + "' takes " + std::to_string(found->second.arguments) + " arguments, not " +
                std::to_string(arguments.size())
            );
        }
        return found->second.f(arguments.data());
    }

    const std::function<double(const std::string&)>& variable_;
    const std::map<std::string, double, std::less<>>& names_;
};

} // namespace

double evaluateExpression(
    std::string_view text, const std::function<double(const std::string&)>& variable,
    const std::map<std::string, double, std::less<>>& names
)
{
    return Expression(text, variable, names).value();
}

} // namespace slosh
