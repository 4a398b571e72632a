// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/Axis.hpp"

#include <limits>

namespace slosh
{

/// One value of each axis: what one run computes with.
struct Setting
{
    std::vector<std::size_t> values; ///< of each axis, in the order of the axes
    std::string name;                ///< of the run and its folder: "particleSpacing=0.02_alpha=0.01"
    std::string scheme;              ///< all but the spacing: "alpha=0.01"; "-" where only the spacing is varied
    double wantedSpacing = std::numeric_limits<double>::quiet_NaN(); ///< [m], where an axis sets it by a number
    Edits edits;
};

/// The settings of one dictionary:
///     vary product;                   // every value of each axis with every value of the others (the default)
///     vary oneAtATime;                // those that differ from `base` in one axis at most
///     base { alpha 0.01; }            // default for each axis: its first value
/// Throws CaseError.
std::vector<Setting> readSettings(const Dictionary& dict, const std::vector<Axis>& axes);

/// Whether two settings differ in `axis` and in no other.
bool differOnlyIn(std::size_t axis, const Setting& a, const Setting& b);

} // namespace slosh
