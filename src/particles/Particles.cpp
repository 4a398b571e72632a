// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/Particles.hpp"

namespace slosh
{

void Particles::resize(std::ptrdiff_t fluid, std::ptrdiff_t wall)
{
    nFluid = fluid;
    nWall = wall;
    const std::ptrdiff_t n = fluid + wall;
    r.resize(n, Vec::Zero());
    v.resize(n, Vec::Zero());
    rho.resize(n, 0.0);
    p.resize(n, 0.0);
    id.resize(n, 0);
}

} // namespace slosh
