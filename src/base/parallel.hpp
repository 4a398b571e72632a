// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace slosh
{

/// Calls f(begin, end) for blocks of at most `block` indices of [0, n), on all threads. Blocks do not depend on the
/// number of threads, so whatever is computed per block has the same bits at any number. f must not throw. Each thread
/// has a contiguous range, the same in every loop over the same n: what it packed it finds in its own cache
/// (docs/performance.md).
template <class F>
void parallelBlocks(std::ptrdiff_t n, std::ptrdiff_t block, const F& f)
{
    const std::ptrdiff_t blocks = (n + block - 1) / block;
#pragma omp parallel for schedule(static) if (blocks > 1)
    for (std::ptrdiff_t k = 0; k < blocks; ++k)
    {
        f(k * block, std::min(n, (k + 1) * block));
    }
}

/// Calls f(k) for each k of [0, n), tasks of unequal cost, on all threads: each takes the next that is left. f must not
/// throw, and what it computes must not depend on who computes it.
template <class F>
void parallelTasks(std::ptrdiff_t n, const F& f)
{
#pragma omp parallel for schedule(dynamic) if (n > 1)
    for (std::ptrdiff_t k = 0; k < n; ++k)
    {
        f(k);
    }
}

/// Particles a thread takes at a time in loops over them. Small, so that threads have equal shares in small cases too;
/// the same in all, so that each finds in its own cache what it wrote in the loop before.
inline constexpr std::ptrdiff_t particlesPerBlock = 32;

/// Calls f(i) for each i of [0, n), on all threads; for cheap bodies.
template <class F>
void parallelFor(std::ptrdiff_t n, const F& f)
{
    parallelBlocks(
        n, particlesPerBlock,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                f(i);
            }
        }
    );
}

/// combine(... combine(combine(zero, partial(block 0)), partial(block 1)) ...): a reduction in a fixed order, hence
/// with the same bits at any number of threads. partial(begin, end) -> T.
template <class T, class Partial, class Combine>
T parallelReduce(std::ptrdiff_t n, T zero, const Partial& partial, const Combine& combine)
{
    static_assert(!std::is_same_v<T, bool>, "threads would write bits of one byte");
    constexpr std::ptrdiff_t block = 4 * particlesPerBlock;
    const std::ptrdiff_t blocks = (n + block - 1) / block;
    std::vector<T> partials(blocks, zero);
    parallelBlocks(
        n, block, [&](std::ptrdiff_t begin, std::ptrdiff_t end) { partials[begin / block] = partial(begin, end); }
    );
    T result = zero;
    for (const T& p : partials)
    {
        result = combine(std::move(result), p);
    }
    return result;
}

} // namespace slosh
