// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/threads.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace slosh
{

namespace
{

int threadsAtStart()
{
    const char* const text = std::getenv("OMP_NUM_THREADS");
    if (text != nullptr && *text != '\0')
    {
        const std::string list = text; // of nested loops: the first counts
        return numberOfThreads("the variable OMP_NUM_THREADS", list.substr(0, list.find(',')));
    }
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::atomic<int> wanted = 0; ///< none yet: 0

void pauseShortly()
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("isb" ::: "memory");
#endif
}

/// Returns when `value` is not `old` any more; reads what was written before it was changed.
void waitWhile(const std::atomic<std::uint32_t>& value, std::uint32_t old)
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::microseconds(50);
    do
    {
        for (int k = 0; k < 8; ++k)
        {
            if (value.load(std::memory_order_acquire) != old)
            {
                return;
            }
            pauseShortly();
        }
    } while (Clock::now() < end);
    value.wait(old, std::memory_order_acquire);
}

/// Whether this thread is in a call of onThreads().
thread_local bool isInside = false;

/// The threads beside the one that calls, each of which has a share of its own. One that has not begun with it when the
/// calling thread is through with its own is not waited for: the calling thread takes that share, too.
class Team
{
public:
    ~Team() { resize(1); }

    void resize(std::size_t shares)
    {
        if (shares == taken_.size())
        {
            return;
        }
        isOver_ = true;
        begin();
        for (std::thread& thread : others_)
        {
            thread.join();
        }
        isOver_ = false;
        others_.clear();
        taken_ = std::vector<std::atomic<std::uint32_t>>(shares);
        for (std::size_t share = 0; share < shares; ++share)
        {
            taken_[share] = call_.load();
        }
        for (std::size_t share = 1; share < shares; ++share)
        {
            others_.emplace_back([this, share, call = call_.load()] { serve(share, call); });
        }
    }

    void run(void (*f)(const void*, int, int), const void* context)
    {
        f_ = f;
        context_ = context;
        left_ = static_cast<std::uint32_t>(taken_.size());
        const std::uint32_t call = begin();
        for (std::size_t share = 0; share < taken_.size(); ++share)
        {
            takeShare(share, call);
        }
        for (std::uint32_t left = 0; (left = left_) != 0;)
        {
            waitWhile(left_, left);
        }
    }

private:
    std::uint32_t begin()
    {
        const std::uint32_t call = ++call_;
        call_.notify_all();
        return call;
    }

    void serve(std::size_t share, std::uint32_t call)
    {
        isInside = true;
        for (;;)
        {
            waitWhile(call_, call);
            call = call_;
            if (isOver_)
            {
                return;
            }
            takeShare(share, call);
        }
    }

    /// Runs a share of a call once: does nothing if another thread has taken it. When the call is over, all of its
    /// shares have been taken.
    void takeShare(std::size_t share, std::uint32_t call)
    {
        std::uint32_t before = call - 1;
        if (!taken_[share].compare_exchange_strong(before, call))
        {
            return;
        }
        f_(context_, static_cast<int>(share), static_cast<int>(taken_.size()));
        if (--left_ == 0)
        {
            left_.notify_one();
        }
    }

    std::vector<std::thread> others_;
    std::vector<std::atomic<std::uint32_t>> taken_ = std::vector<std::atomic<std::uint32_t>>(1); ///< in which call
    void (*f_)(const void*, int, int) = nullptr;
    const void* context_ = nullptr;
    std::atomic<bool> isOver_ = false;
    alignas(64) std::atomic<std::uint32_t> call_ = 0; ///< which one it is
    alignas(64) std::atomic<std::uint32_t> left_ = 0; ///< shares that are not done
};

} // namespace

int threads()
{
    if (wanted == 0)
    {
        wanted = threadsAtStart();
    }
    return wanted;
}

void setThreads(int n)
{
    wanted = std::max(1, n);
}

int numberOfThreads(const std::string& name, const std::string& text)
{
    int n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (error != std::errc() || end != text.data() + text.size() || n < 1 || n > 1024)
    {
        throw CaseError(name + " is " + text + "; expected a whole number from 1 to 1024");
    }
    return n;
}

void onThreads(void (*f)(const void* context, int share, int shares), const void* context)
{
    static Team team;
    static std::mutex oneAtATime;
    const int n = threads();
    std::unique_lock lock(oneAtATime, std::defer_lock);
    if (n == 1 || isInside || !lock.try_lock())
    {
        f(context, 0, 1);
        return;
    }
    team.resize(static_cast<std::size_t>(n));
    isInside = true;
    team.run(f, context);
    isInside = false;
}

} // namespace slosh
