// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "particles/Particles.hpp"

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace slosh
{

/// combine() of partial(begin, end) over the liquid, brick by brick (Particles::bricks), each in blocks of its
/// particles; then of the bricks in their order. What a whole run is decided by is summed so: its bits do not depend on
/// threads, and a brick's part not on where the others are. combine(zero, x) = x.
template <class T, class Partial, class Combine>
T reduceLiquid(const Particles& particles, const T& zero, const Partial& partial, const Combine& combine)
{
    constexpr std::ptrdiff_t block = 4 * particlesPerBlock;
    const std::vector<std::ptrdiff_t> one = {0, particles.nFluid};
    const std::vector<std::ptrdiff_t>& bricks = particles.bricks.empty() ? one : particles.bricks;
    std::vector<std::ptrdiff_t> starts;
    starts.reserve(particles.nFluid / block + bricks.size());
    for (std::size_t k = 0; k + 1 < bricks.size(); ++k)
    {
        for (std::ptrdiff_t begin = bricks[k]; begin < bricks[k + 1]; begin += block)
        {
            starts.push_back(begin);
        }
    }
    starts.push_back(particles.nFluid);
    const auto blocks = static_cast<std::ptrdiff_t>(starts.size()) - 1;
    std::vector<T> partials(blocks, zero);
    parallelBlocks(
        blocks, 1, [&](std::ptrdiff_t k, std::ptrdiff_t) { partials[k] = partial(starts[k], starts[k + 1]); }
    );
    T result = zero;
    std::ptrdiff_t k = 0;
    for (std::size_t brick = 0; brick + 1 < bricks.size(); ++brick)
    {
        T ofBrick = zero;
        for (; k < blocks && starts[k] < bricks[brick + 1]; ++k)
        {
            ofBrick = combine(std::move(ofBrick), partials[k]);
        }
        result = combine(std::move(result), ofBrick);
    }
    return result;
}

/// sum_i f(i) over the liquid.
template <class F>
double sumOverLiquid(const Particles& particles, const F& f)
{
    return reduceLiquid(
        particles, 0.0,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            double sum = 0;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                sum += f(i);
            }
            return sum;
        },
        std::plus<>()
    );
}

/// The larger one; one that is not a number counts for infinite.
inline double larger(double a, double b)
{
    return b <= a ? a : b == b ? b : std::numeric_limits<double>::infinity();
}

/// max_i f(i) over the liquid, f >= 0, by larger().
template <class F>
double maxOverLiquid(const Particles& particles, const F& f)
{
    return reduceLiquid(
        particles, 0.0,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            double most = 0;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                most = larger(most, f(i));
            }
            return most;
        },
        larger
    );
}

} // namespace slosh
