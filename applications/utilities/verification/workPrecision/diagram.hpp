// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ErrorTable.hpp"
#include "Study.hpp"

namespace slosh
{

/// A gnuplot script that draws workPrecision.svg and workPrecision.png where it is run: for each table a panel of
/// errors over CPU seconds, both logarithmic, a line for each scheme, the Pareto front behind them with the spacings of
/// its runs, the targets as dotted lines. The numbers stand in the script. "" where there is nothing to draw.
std::string diagramScript(const std::string& title, const Study& study, const std::vector<ErrorTable>& tables);

} // namespace slosh
