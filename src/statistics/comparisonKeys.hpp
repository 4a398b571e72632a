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
    .sentence = "postProcessing/<function>/<file>; all start times are joined, a restart replacing what it repeats"};
inline constexpr Key column{
    .name = "column", .example = "1", .range = notNegative, .sentence = "0 is the time; a vector is three columns"};
inline constexpr Key scale{.name = "scale", .otherwise = "1", .sentence = "the values are multiplied by it"};
inline constexpr Key offset{.name = "offset", .otherwise = "0", .sentence = "what is added to them after that"};
inline constexpr Key filter{
    .name = "filter",
    .otherwise = "0",
    .unit = unit::second,
    .range = notNegative,
    .sentence = "width of a centred moving average; 0: none"};
inline constexpr Key timeStart{
    .name = "timeStart", .leftOut = "the first sample", .example = "0", .unit = unit::second};
inline constexpr Key timeEnd{.name = "timeEnd", .leftOut = "the last sample", .example = "0.02", .unit = unit::second};
inline constexpr Key unit{.name = "unit", .leftOut = "none", .example = "Pa", .sentence = "for the table"};
inline constexpr Key quantity{.name = "quantity", .example = "meanPeak", .options = quantityOptions};
inline constexpr Key ratio{
    .name = "ratio",
    .otherwise = "no",
    .example = "yes",
    .sentence = "whether the figure over that of the reference stands in place of its error",
    .alternative = true};
inline constexpr Key stated{
    .name = "stated",
    .leftOut = "none",
    .example = "0.065",
    .sentence = "what somebody states of the ratio",
    .alternative = true};
inline constexpr Key bound{
    .name = "bound",
    .leftOut = "none",
    .example = "0",
    .range = notNegative,
    .sentence = "the largest |error| that is accepted (a share, the distance from a range or from 0, seconds of an "
                "instant): beyond it compareSamples ends with status 1"};

} // namespace comparison

/// All of them: what a comparison has but its reference, which differs with the program.
Keys comparisonKeys();

} // namespace slosh
