#pragma once

#include "geometry/Tank.hpp"
#include "particles/particleFiles.hpp"

#include <vector>

namespace slosh
{

/// Indices of the liquid particles whose centre is in a wall or a body, or beyond: what has leaked. Empty in a sound
/// run.
std::vector<std::ptrdiff_t> particlesOutside(const Tank& tank, const Particles& particles, Frame frame,
                                             const RigidState& tankState);

} // namespace slosh
