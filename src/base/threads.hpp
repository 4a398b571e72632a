// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

namespace slosh
{

/// The threads that the loops of base/parallel.hpp use: OMP_NUM_THREADS (its first number), or all processors that the
/// process may run on, unless setThreads() says otherwise.
int threads();
/// n >= 1.
void setThreads(int n);

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
