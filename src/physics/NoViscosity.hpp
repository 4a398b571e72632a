// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Pair.hpp"

#include <string_view>

namespace slosh
{

/// An inviscid liquid: nothing is added to the pressure.
struct NoViscosity
{
    static constexpr std::string_view name = "none";

    template <class S>
    struct InLoop
    {
        template <int dim>
        Zero operator()(const Pair<dim, S>&, const S&) const
        {
            return {};
        }
    };

    template <class S>
    InLoop<S> inLoop(int) const
    {
        return {};
    }
};

} // namespace slosh
