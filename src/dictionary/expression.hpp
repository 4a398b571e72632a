// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace slosh
{

/// The value of an arithmetic expression as #eval and #calc take it: + - * / % ^, parentheses, pi(), e(), degToRad(x),
/// radToDeg(x), sqrt cbrt exp log log10 sin cos tan asin acos atan sinh cosh tanh floor ceil round mag abs sqr, pow(x,
/// y), atan2(y, x), min, max, hypot, C's constants M_PI, M_E ...; $name and ${name} are asked of `variable`. Angles in
/// rad. `names`: values that stand for themselves, such as the coordinates x y z of a field. Throws
/// std::invalid_argument saying what is wrong.
double evaluateExpression(
    std::string_view text, const std::function<double(const std::string&)>& variable,
    const std::map<std::string, double, std::less<>>& names = {}
);

} // namespace slosh
