// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace slosh
{

/// The numbers of a file of samples, line by line: comments left out, parentheses taken for blanks.
std::vector<std::vector<double>> rowsOf(const std::string& text);

/// Its lines that are no comments.
std::string samplesOf(const std::string& text);

} // namespace slosh
