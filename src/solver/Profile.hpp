// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <utility>

namespace slosh
{

/// What a run's time is spent on.
enum class Work : std::size_t
{
    rightHandSides, ///< sums over the pairs of each of its particles
    walls,          ///< what they see of the liquid and show to it; pressure of the liquid, packing of both
    lists,          ///< neighbour lists: whether they hold, sorting, building
    density,        ///< its re-initialisation
    integration,    ///< new positions, velocities and densities; stops at walls
    timeStep,       ///< reductions: largest speed, acceleration, density deviation
    energyBudget,
    functions, ///< probes, gauges, forces ...
    writing,
    other
};

inline constexpr std::array<std::string_view, 10> workNames = {"right-hand sides", "walls",
                                                               "neighbour lists",  "moving least squares",
                                                               "integration",      "time step and soundness",
                                                               "energy budget",    "functions",
                                                               "writing",          "other"};

/// Seconds of the clock by kind of work. Sections nest: the inner one's time is not the outer one's. Entering one reads
/// a clock, some tens of nanoseconds.
class Profile
{
public:
    class Section
    {
    public:
        Section(Profile& profile, Work work) : profile_(profile), outer_(profile.enter(work)) {}
        ~Section() { profile_.enter(outer_); }
        Section(const Section&) = delete;
        Section& operator=(const Section&) = delete;

    private:
        Profile& profile_;
        Work outer_;
    };

    [[nodiscard]] Section section(Work work) { return {*this, work}; }

    double seconds(Work work) const { return seconds_[static_cast<std::size_t>(work)]; }
    double total() const
    {
        double sum = 0;
        for (const double s : seconds_)
        {
            sum += s;
        }
        return sum;
    }

private:
    using Clock = std::chrono::steady_clock;

    Work enter(Work work)
    {
        const Clock::time_point now = Clock::now();
        seconds_[static_cast<std::size_t>(work_)] += std::chrono::duration<double>(now - since_).count();
        since_ = now;
        return std::exchange(work_, work);
    }

    std::array<double, workNames.size()> seconds_{};
    Clock::time_point since_ = Clock::now();
    Work work_ = Work::other;
};

} // namespace slosh
