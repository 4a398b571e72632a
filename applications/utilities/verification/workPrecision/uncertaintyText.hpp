// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FigureUncertainty.hpp"
#include "Study.hpp"

namespace slosh
{

/// Lines of a figure that has one spacing or more: order, limit at spacing 0, value at the finest, last change, the
/// parts of the uncertainty.
std::string uncertaintyTable(const FigureUncertainty& figure, const Study& study);

/// "3.15 kPa +- 7 %, at dx = 6 mm, 81 s of CPU; +- 5 % needs about dx = 4 mm and 4 min of CPU": what follows the name
/// of the figure. Of fewer than four spacings it has the change between the two finest and says how many are missing.
/// The smaller uncertainty is the next one of the study's targets, or half; the spacing that it needs is the one where
/// the fit's error has fallen enough for U_d, U_s being what it is; the time is costOfFinerSpacing's.
std::string uncertaintySentence(const FigureUncertainty& figure, const Study& study);

/// "system/workPrecisionDict:12: axes have 3 spacings with a figure; expected at least 4 ..."
std::string fewSpacings(const Study& study, std::size_t count);

std::string duration(double seconds);  ///< "81 s", "4 min", "2.5 h"
std::string lengthText(double metres); ///< "6 mm", "0.15 m"

} // namespace slosh
