// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgressLine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace slosh
{

namespace
{

constexpr double refreshInterval = 0.2; // [s]

int findTerminal()
{
    const char* kind = std::getenv("TERM");
    if (kind != nullptr && std::string_view(kind) == "dumb")
    {
        return -1; // cannot overwrite a line
    }
    return isatty(STDOUT_FILENO) != 0 ? STDOUT_FILENO : isatty(STDERR_FILENO) != 0 ? STDERR_FILENO : -1;
}

/// Where the program runs in the background, somebody types on this terminal.
bool isInForeground(int terminal)
{
    const pid_t foreground = tcgetpgrp(terminal);
    return foreground == -1 || foreground == getpgrp();
}

std::size_t columns(int terminal)
{
    winsize size{};
    return ioctl(terminal, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : 80;
}

/// "35 s", "2 min 05 s", "3 h 20 min", "4 d 06 h".
std::string duration(double seconds)
{
    if (!(seconds < 1000 * 86400.0))
    {
        return "?";
    }
    const long s = std::lround(seconds);
    char words[40];
    if (s < 60)
    {
        std::snprintf(words, sizeof words, "%ld s", s);
    }
    else if (s < 3600)
    {
        std::snprintf(words, sizeof words, "%ld min %02ld s", s / 60, s % 60);
    }
    else if (s < 86400)
    {
        std::snprintf(words, sizeof words, "%ld h %02ld min", s / 3600, s % 3600 / 60);
    }
    else
    {
        std::snprintf(words, sizeof words, "%ld d %02ld h", s / 86400, s % 86400 / 3600);
    }
    return words;
}

/// In one call, so that lines of the program's other stream do not fall into it. A terminal that has gone is no error.
void put(int terminal, const std::string& text)
{
    [[maybe_unused]] const auto written = write(terminal, text.data(), text.size());
}

} // namespace

void RecentRate::add(double simulated, double real)
{
    const double weight = std::exp(-real / memory_);
    simulated_ = simulated_ * weight + simulated;
    real_ = real_ * weight + real;
}

double RecentRate::realSeconds(double simulated) const
{
    return simulated_ > 0 && real_ >= 1 ? simulated * real_ / simulated_ : std::numeric_limits<double>::infinity();
}

ProgressLine::ProgressLine(const Controls& time) : time_(time), terminal_(findTerminal()), beginTime_(time.time()) {}

void ProgressLine::step(long outside, long stopped)
{
    if (lastClock_ < 0) // reading the case does not count
    {
        lastTime_ = time_.time();
        lastClock_ = time_.now().clock;
    }
    const double elapsed = time_.now().clock - lastClock_;
    if (terminal_ < 0 || elapsed < refreshInterval)
    {
        return;
    }
    rate_.add(time_.time() - lastTime_, elapsed);
    lastTime_ = time_.time();
    lastClock_ = time_.now().clock;
    if (isInForeground(terminal_))
    {
        put(terminal_, "\r" + text(outside, stopped).substr(0, columns(terminal_) - 1) + "\033[K");
        shown_ = true;
    }
}

void ProgressLine::clear()
{
    if (shown_)
    {
        put(terminal_, "\r\033[K");
        shown_ = false;
    }
}

std::string ProgressLine::text(long outside, long stopped) const
{
    const double t = time_.time(), end = time_.endTime();
    const double first = std::min(beginTime_, 0.0); // a run that goes on goes on with its share, too
    const double done = end > first ? std::clamp((t - first) / (end - first), 0.0, 1.0) : 1.0;
    const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(std::abs(end) + 1e-3))), 0, 6);
    char line[200];
    std::snprintf(
        line, sizeof line, "%5.1f %%  t = %.*f of %.6g s  left %s  dt = %.2e s  outside %ld  stopped at walls %ld",
        std::floor(1000 * done) / 10, decimals, t, end, duration(rate_.realSeconds(std::max(0.0, end - t))).c_str(),
        time_.deltaT(), outside, stopped
    );
    return line;
}

} // namespace slosh
