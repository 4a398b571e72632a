// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "base/scalarMath.hpp"
#include "physics/BodyForce.hpp"

#include <array>
#include <string_view>

namespace slosh
{

/// Nothing is added to the continuity equation.
struct NoDensityDiffusion
{
    static constexpr std::string_view name = "none";

    template <int dim, class S>
    struct AroundParticle
    {
        template <class Pair>
        Zero operator()(const Pair&) const
        {
            return {};
        }
    };

    template <int dim, class S>
    AroundParticle<dim, S>
    around(const std::array<int, 3>&, double, const BodyForce&, const std::array<Vec, rowsOf<S>>&, const std::array<double, rowsOf<S>>&)
        const
    {
        return {};
    }
};

} // namespace slosh
