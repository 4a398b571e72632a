// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/tokenize.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// Tokens as a dictionary has them, each behind a space.
std::string textOf(const std::vector<Token>& tokens);

/// Sets in `to` the entry of `from`, a vector or a Function1 of vectors, with its vectors multiplied by M: M f(t).
/// Throws CaseError for a Function1 other than constant, table, sine, cosine and square.
void setTurned(const Dictionary& from, const std::string& key, const Mat& M, Dictionary& to);

} // namespace slosh
