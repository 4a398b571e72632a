// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampling/FunctionObject.hpp"

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace slosh
{

/// All functions of a run, each with its own schedule, independent of when times are written.
class FunctionObjects
{
public:
    FunctionObjects() = default;

    /// `controlDict`: its functions and writePrecision. Throws CaseError: unknown type or key, a point outside the
    /// tank.
    static FunctionObjects read(
        const Dictionary& controlDict, const std::filesystem::path& folder, const Scene& scene,
        const std::string& startName
    );

    /// Whether any is due at the end of the step from `before` to `now`.
    bool isDue(const Instant& before, const Instant& now) const;
    /// Runs those that are due, `now` being the snapshot's time.
    void execute(const Snapshot& snapshot, const Instant& before, const Instant& now);
    /// Runs all: at the start of a case, and for samples from written times.
    void executeAll(const Snapshot& snapshot);
    /// The next instant a step must not pass, [s].
    double nextInstant(double now) const;

    /// Whether any needs the energy budget.
    bool wantBudget() const;
    std::vector<std::string> names() const;
    std::vector<std::filesystem::path> files() const;

private:
    struct Function
    {
        std::string name;
        Schedule schedule;
        double start = -std::numeric_limits<double>::infinity();
        double end = std::numeric_limits<double>::infinity();
        std::unique_ptr<FunctionObject> object;

        bool active(double now) const { return now >= start && now <= end; }
        bool isDue(const Instant& before, const Instant& now) const
        {
            return active(now.time) && schedule.isDue(before, now);
        }
    };
    std::vector<Function> functions_;
};

/// All entries of system/probesDict, and of functions in system/controlDict.
Keys probesDictKeys();

} // namespace slosh
