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
    std::string family; ///< the scheme without the axes of members: the same for all members of an ensemble
    double wantedSpacing = std::numeric_limits<double>::quiet_NaN(); ///< [m], where an axis sets it by a number
    Edits edits;
};

/// The entries that say which settings are made of axes. The example of `base` is the program's.
namespace settingEntries
{

inline constexpr Key vary{
    .name = "vary",
    .otherwise = "product",
    .options = []
    {
        return Options{
            {"product", "all combinations of the values"},
            {"oneAtATime", "settings that differ from the base in one axis"}};
    }};
inline constexpr Key base{
    .name = "base", .leftOut = "the first value of each axis", .sentence = "base of oneAtATime", .entries = [] {
        return Keys();
    }};

} // namespace settingEntries

/// The settings of one dictionary, by these entries of it. Throws CaseError.
std::vector<Setting> readSettings(const Dictionary& dict, const std::vector<Axis>& axes);

/// Whether two settings differ in `axis` and in no other.
bool differOnlyIn(std::size_t axis, const Setting& a, const Setting& b);

} // namespace slosh
