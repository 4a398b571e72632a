// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/threads.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace slosh
{

/// Calls f(begin, end) for blocks of at most `block` indices of [0, n), on all threads. Blocks do not depend on the
/// number of threads, so whatever is computed per block has the same bits at any number. f must not throw. Each thread
/// has a contiguous range, the same in every loop over the same n, unless it begins too late (onThreads): what it
/// packed it finds in its own cache (docs/performance.md).
template <class F>
void parallelBlocks(std::ptrdiff_t n, std::ptrdiff_t block, const F& f)
{
    const std::ptrdiff_t blocks = (n + block - 1) / block;
    const auto share = [&](std::ptrdiff_t thread, std::ptrdiff_t threads)
    {
        for (std::ptrdiff_t k = blocks * thread / threads; k < blocks * (thread + 1) / threads; ++k)
        {
            f(k * block, std::min(n, (k + 1) * block));
        }
    };
    blocks > 1 ? onThreads(share) : share(0, 1);
}

/// Calls f(k) for each k of [0, n), tasks of unequal cost, on all threads: each takes those of a contiguous range, in
/// which neighbours share what they need, and then what is left of the others' ranges. f must not throw, and what it
/// computes must not depend on who computes it.
template <class F>
void parallelTasks(std::ptrdiff_t n, const F& f)
{
    struct alignas(64) Range // of a cache line of its own
    {
        std::atomic<std::ptrdiff_t> next;
        std::ptrdiff_t end;
    };
    const std::ptrdiff_t ranges = std::min<std::ptrdiff_t>(n, threads());
    std::vector<Range> left(ranges);
    for (std::ptrdiff_t k = 0; k < ranges; ++k)
    {
        left[k].next.store(n * k / ranges, std::memory_order_relaxed);
        left[k].end = n * (k + 1) / ranges;
    }
    const auto take = [&](std::ptrdiff_t share, int)
    {
        for (std::ptrdiff_t r = 0; r < ranges; ++r)
        {
            Range& range = left[(share + r) % ranges];
            for (std::ptrdiff_t k = range.next++; k < range.end; k = range.next++)
            {
                f(k);
            }
        }
    };
    ranges > 1 ? onThreads(take) : take(0, 1);
}

/// What tasks of one parallelTasks have to do for others: k waits until count(k) of them have said so.
class Countdowns
{
public:
    void start(const std::vector<int>& counts)
    {
        counts_ = counts;
        left_ = std::vector<Left>(counts.size());
        for (std::size_t k = 0; k < counts.size(); ++k)
        {
            left_[k].count.store(counts[k], std::memory_order_relaxed);
        }
    }
    /// One of those that k waits for is done; whether it is the last. If so, what the others wrote before is seen here,
    /// and k waits for as many again.
    bool isLast(std::ptrdiff_t k)
    {
        if (left_[k].count.fetch_sub(1, std::memory_order_acq_rel) != 1)
        {
            return false;
        }
        left_[k].count.store(counts_[k], std::memory_order_relaxed);
        return true;
    }

private:
    struct alignas(64) Left // of a cache line of its own
    {
        std::atomic<int> count;
    };
    std::vector<int> counts_;
    std::vector<Left> left_;
};

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
