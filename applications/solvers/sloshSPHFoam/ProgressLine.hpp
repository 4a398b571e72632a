// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Controls.hpp"

#include <string>

namespace slosh
{

/// Simulated seconds per real second, averaged over the recent past: a step of that age has the weight
/// exp(-age/memory).
class RecentRate
{
public:
    /// A stretch of the run: `simulated` in `real` seconds.
    void add(double simulated, double real);
    /// Real seconds that `simulated` ones will take; infinite in the first second.
    double realSeconds(double simulated) const;

private:
    static constexpr double memory_ = 20; ///< [s]
    double simulated_ = 0, real_ = 0;
};

/// A line on the terminal that is overwritten in place: how much is done, the time left at the recent rate, the step,
/// lost particles. On stdout where that is a terminal, else on stderr (`sloshSPHFoam > log`); nothing where neither is
/// one, or the program is in the background. Takes the clock that Controls reads anyway, and writes five times a second
/// at most.
class ProgressLine
{
public:
    explicit ProgressLine(const Controls& time);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// A step has ended. `outside`: particles outside the tank now; `stopped`: times that one was stopped at a wall.
    void step(long outside, long stopped);
    /// Takes the line off the terminal: before anything else is printed.
    void clear();

private:
    std::string text(long outside, long stopped) const;

    const Controls& time_;
    int terminal_; ///< file descriptor; -1: none
    bool shown_ = false;
    double beginTime_;
    double lastTime_ = 0, lastClock_ = -1; ///< of the last refreshing
    RecentRate rate_;
};

} // namespace slosh
