// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/Quantity.hpp"

namespace slosh
{

/// Entries of a comparison, which compareSamples reads, and workPrecision and sloshSweep for it.
namespace comparison
{

inline constexpr Key description{
    .name = "description", .leftOut = "the name", .example = "\"mean of the highest pressure per period\""};
inline constexpr Key samples{
    .name = "samples",
    .example = "\"pressure/p\"",
    .sentence =
        "postProcessing/<function>/<file>; all start times are joined; a restart replaces the samples that it repeats"};
inline constexpr Key column{
    .name = "column", .example = "1", .range = notNegative, .sentence = "0 is the time; a vector has three columns"};
inline constexpr Key scale{.name = "scale", .otherwise = "1", .sentence = "the values are multiplied by it"};
inline constexpr Key offset{.name = "offset", .otherwise = "0", .sentence = "added to the values after scaling"};
inline constexpr Key filter{
    .name = "filter",
    .otherwise = "0",
    .unit = unit::second,
    .range = notNegative,
    .sentence = "width of a centred moving average; 0: none"};
inline constexpr Key timeStart{
    .name = "timeStart", .leftOut = "the first sample", .example = "0", .unit = unit::second};
inline constexpr Key timeEnd{.name = "timeEnd", .leftOut = "the last sample", .example = "0.02", .unit = unit::second};
inline constexpr Key unit{.name = "unit", .leftOut = "none", .example = "Pa", .sentence = "unit in the table"};
inline constexpr Key quantity{.name = "quantity", .example = "meanPeak", .options = quantityOptions};
inline constexpr Key ratio{
    .name = "ratio",
    .otherwise = "no",
    .example = "yes",
    .sentence = "whether the ratio of the figure to the reference replaces the error",
    .alternative = true};
inline constexpr Key stated{
    .name = "stated",
    .leftOut = "none",
    .example = "0.065",
    .sentence = "a stated value of the ratio",
    .alternative = true};
inline constexpr Key bound{
    .name = "bound",
    .leftOut = "none",
    .example = "0",
    .range = notNegative,
    .sentence = "largest accepted |error| (relative, or the distance from a range or from 0, or seconds for an "
                "instant); beyond it compareSamples exits with status 1"};

} // namespace comparison

/// All of them: what a comparison has but its reference, which differs with the program.
Keys comparisonKeys();

} // namespace slosh
