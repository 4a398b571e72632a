// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "fluid/TaitEquation.hpp"
#include "viscosities/Coefficient.hpp"

#include <array>
#include <string_view>

namespace slosh
{

/// An inviscid liquid: nothing is added to the pressure.
struct NoViscosity
{
    static constexpr std::string_view name = "none";
    static constexpr std::string_view sentence = "Inviscid liquid";
    static constexpr std::array<Coefficient<NoViscosity>, 0> coefficients{};

    static NoViscosity of(const TaitEquation&) { return {}; }
    double kinematic(int, double, double) const { return 0; }

    template <class S>
    struct InLoop
    {
        template <class Pair>
        Zero operator()(const Pair&, const S&) const
        {
            return {};
        }
    };

    template <class S>
    InLoop<S> inLoop(int, double) const
    {
        return {};
    }
};

} // namespace slosh
