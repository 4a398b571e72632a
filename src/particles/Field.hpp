// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FieldValues.hpp"

#include <string>

namespace slosh
{

/// Particles stand in ranges, one after the other: [liquid | wall].
enum class ParticleRange
{
    liquid,
    wall,
    all
};

/// A quantity that each particle of a range has, besides the five of Particles: by its name sorted, written, read,
/// shown and counted as they are. What owns it declares it, with values of one type and none yet:
///     Field{"meanDiffusion", ParticleRange::liquid, std::vector<double>()}
struct Field
{
    std::string name; ///< of its file in <time>/lagrangian/<cloud>/
    ParticleRange range = ParticleRange::all;
    FieldValues values; ///< from the range's first particle on
};

} // namespace slosh
