// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/signals.hpp"

#include <csignal>

namespace slosh
{

namespace
{

volatile std::sig_atomic_t write = 0;
volatile std::sig_atomic_t stop = 0;

void noteWrite(int)
{
    write = 1;
}

void noteStop(int signal)
{
    stop = signal;
}

void handle(int signal, void (*handler)(int), int flags)
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = flags | SA_RESTART; // writing goes on
    sigaction(signal, &action, nullptr);
}

} // namespace

void listenToSignals()
{
    handle(SIGUSR1, noteWrite, 0);
    handle(SIGTERM, noteStop, static_cast<int>(SA_RESETHAND));
    handle(SIGINT, noteStop, static_cast<int>(SA_RESETHAND));
}

bool writeRequested()
{
    const bool requested = write != 0;
    write = 0;
    return requested;
}

int stopSignal()
{
    return stop;
}

} // namespace slosh
