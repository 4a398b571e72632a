// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernels/KernelChoice.hpp"

#include <cstddef>
#include <variant>

namespace slosh
{

/// f.operator()<K>() of every kernel K.
template <std::size_t k = 0, class F>
void forEveryKernel(const F& f)
{
    if constexpr (k < std::variant_size_v<KernelChoice>)
    {
        f.template operator()<std::variant_alternative_t<k, KernelChoice>>();
        forEveryKernel<k + 1>(f);
    }
}

} // namespace slosh
