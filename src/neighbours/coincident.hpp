// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

#include <cstddef>
#include <optional>
#include <utility>

namespace slosh
{

/// Indices of two liquid particles nearer to each other than `distance`, [m], the first by index; nothing in a sound
/// state. Two particles in one place exert no force on each other and feel the same from all others: they never part.
std::optional<std::pair<std::ptrdiff_t, std::ptrdiff_t>> coincident(const Particles& particles, double distance);

} // namespace slosh
