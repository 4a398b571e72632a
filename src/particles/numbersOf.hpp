// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <cstddef>
#include <vector>

namespace slosh
{

/// The numbers of the particles [begin, end) one after the other, all components of a vector, so that arithmetic that
/// is the same for each is done for several at a time.
inline Eigen::Map<Eigen::ArrayXd> numbersOf(std::vector<Vec>& field, std::ptrdiff_t begin, std::ptrdiff_t end)
{
    static_assert(sizeof(Vec) == 3 * sizeof(double));
    return {field.data()->data() + 3 * begin, 3 * (end - begin)};
}
inline Eigen::Map<const Eigen::ArrayXd>
numbersOf(const std::vector<Vec>& field, std::ptrdiff_t begin, std::ptrdiff_t end)
{
    return {field.data()->data() + 3 * begin, 3 * (end - begin)};
}
inline Eigen::Map<Eigen::ArrayXd> numbersOf(std::vector<double>& field, std::ptrdiff_t begin, std::ptrdiff_t end)
{
    return {field.data() + begin, end - begin};
}
inline Eigen::Map<const Eigen::ArrayXd>
numbersOf(const std::vector<double>& field, std::ptrdiff_t begin, std::ptrdiff_t end)
{
    return {field.data() + begin, end - begin};
}

} // namespace slosh
