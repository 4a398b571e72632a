// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace slosh
{

/// f(0), f(1) ... f(n - 1), with constants: arrays that are indexed so stay in registers, where gcc 12 keeps those of a
/// loop in memory.
template <std::size_t n, class F>
[[gnu::always_inline]] inline void unrolled(const F& f)
{
    [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline))
    {
        (f(std::integral_constant<std::size_t, k>()), ...);
    }
    (std::make_index_sequence<n>());
}

} // namespace slosh
