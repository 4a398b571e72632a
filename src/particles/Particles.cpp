// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/Particles.hpp"

#include <utility>

namespace slosh
{

void Particles::resize(std::ptrdiff_t fluid, std::ptrdiff_t wall)
{
    if (fluid != nFluid)
    {
        bricks.clear();
    }
    nFluid = fluid;
    nWall = wall;
    forEachField(
        [&](const auto&, ParticleRange range, auto& values)
        {
            // Eigen's vectors are not zero by themselves.
            using T = typename std::decay_t<decltype(values)>::value_type;
            if constexpr (std::is_same_v<T, Vec>)
            {
                values.resize(size(range), Vec::Zero());
            }
            else
            {
                values.resize(size(range));
            }
        }
    );
}

void Particles::remember(std::vector<Field> wanted)
{
    for (Field& field : wanted)
    {
        for (Field& present : more)
        {
            if (present.name == field.name && present.range == field.range &&
                present.values.index() == field.values.index())
            {
                field.values = std::move(present.values);
                break;
            }
        }
    }
    more = std::move(wanted);
    resize(nFluid, nWall);
}

std::size_t Particles::bytes() const
{
    std::size_t sum = 0;
    forEachField([&](const auto&, ParticleRange, const auto& values) { sum += values.capacity() * sizeof(values[0]); });
    return sum;
}

} // namespace slosh
