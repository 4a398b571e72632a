// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <type_traits>

namespace slosh
{

/// The threads that the loops of base/parallel.hpp use: what setThreads() says; without it OMP_NUM_THREADS (its first
/// number), or all processors that the process may run on. Throws CaseError where the variable is no number of threads.
int threads();
/// n >= 1.
void setThreads(int n);

/// The number of threads that `text` is. Throws CaseError, by `name`, unless it is a whole number from 1 to 1024.
int numberOfThreads(const std::string& name, const std::string& text);

/// Calls f(k, n) for k = 0 ... n - 1, n = threads(), each once, and returns when all are done: each k on a thread of
/// its own, 0 on the calling one, which also takes those that no other has begun with. Called by f itself, or while
/// another thread's call is on: f(0, 1) alone. f must not throw.
///
/// Threads are started at first use. One that waits, for the next call or for the others, spins for 50 us, which is
/// longer than what lies between the loops of a small case, and then sleeps: where other programs want the processors
/// it does not keep them.
void onThreads(void (*f)(const void* context, int share, int shares), const void* context);

template <class F>
void onThreads(const F& f)
{
    onThreads([](const void* context, int share, int shares) { (*static_cast<const F*>(context))(share, shares); }, &f);
}

} // namespace slosh
