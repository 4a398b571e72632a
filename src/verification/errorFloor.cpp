// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/errorFloor.hpp"

namespace slosh
{

std::optional<std::size_t> errorFloor(const std::vector<double>& errors)
{
    constexpr double stillFalling = 0.9;
    for (std::size_t i = 0; i + 2 < errors.size(); ++i)
    {
        if (errors[i + 1] > stillFalling * errors[i] && errors[i + 2] > stillFalling * errors[i + 1])
        {
            return i;
        }
    }
    return std::nullopt;
}

} // namespace slosh
