// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

#include <unordered_map>

namespace slosh
{

/// Where each liquid particle stands in `particles`, by its id: lists sort them, and here they are found again.
inline std::unordered_map<int, std::ptrdiff_t> placesById(const Particles& particles)
{
    std::unordered_map<int, std::ptrdiff_t> places;
    places.reserve(particles.nFluid);
    for (std::ptrdiff_t i = 0; i < particles.nFluid; ++i)
    {
        places.emplace(particles.id[i], i);
    }
    return places;
}

} // namespace slosh
