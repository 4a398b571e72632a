// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseState.hpp"

namespace slosh
{

/// A gnuplot script that draws sweep.svg and sweep.png where it is run, a panel for each result. One axis: a line. Two:
/// a map of colours. More: a curve for each combination of the others. An axis of a single value is left out. Along x
/// is the first frequency, else the first axis; natural frequencies are marked on a frequency, references drawn as
/// dashed curves. The numbers stand in the script. "" where no case has a result.
std::string mapScript(const std::string& title, const Sweep& sweep, const std::vector<CaseState>& states);

} // namespace slosh
