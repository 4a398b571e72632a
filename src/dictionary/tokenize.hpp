// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Token.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace slosh
{

/// Splits text in OpenFOAM's syntax into tokens. Comments are left out; a word may hold balanced parentheses
/// (div(phi,U)), a macro braces (${name}); what follows #eval and #calc, and code #{ ... #}, comes as one string.
/// `file` is for messages. Throws CaseError for a string, comment or expression that does not end, saying where it
/// began.
std::vector<Token> tokenize(std::string_view text, const std::string& file);

/// The number a text is, whole: digits, sign, point and exponent; "nan" and "inf" are words.
bool isNumber(std::string_view text, double& value);

} // namespace slosh
