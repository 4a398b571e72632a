// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/paretoFront.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace slosh
{

std::vector<std::size_t> paretoFront(const std::vector<double>& cost, const std::vector<double>& error)
{
    if (cost.size() != error.size())
    {
        throw CaseError(
            "there are " + std::to_string(cost.size()) + " costs and " + std::to_string(error.size()) + " errors"
        );
    }
    std::vector<std::size_t> byCost;
    byCost.reserve(cost.size());
    for (std::size_t i = 0; i < cost.size(); ++i)
    {
        if (std::isfinite(cost[i]) && std::isfinite(error[i]))
        {
            byCost.push_back(i);
        }
    }
    std::stable_sort(
        byCost.begin(), byCost.end(),
        [&](std::size_t a, std::size_t b) { return cost[a] < cost[b] || (cost[a] == cost[b] && error[a] < error[b]); }
    );
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : byCost)
    {
        if (error[i] < least)
        {
            least = error[i];
            front.push_back(i);
        }
    }
    return front;
}

} // namespace slosh
