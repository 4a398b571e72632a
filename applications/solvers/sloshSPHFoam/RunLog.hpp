// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ProgressLine.hpp"

#include "case/Controls.hpp"
#include "sampling/FunctionObjects.hpp"
#include "scene/Scene.hpp"
#include "solver/WeaklyCompressible.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace slosh
{

/// What the solver says while it runs, in OpenFOAM's manner: the choices at the start, a block of lines now and then
/// (at most a few hundred in a run, and at every write), totals at the end; on a terminal also a line of progress.
class RunLog
{
public:
    /// `warnings`: of the start, see solver/startWarnings.hpp.
    RunLog(
        const Case& theCase, const Controls& time, const Scene& scene, const WeaklyCompressible& solver,
        const FunctionObjects& functions, const std::vector<std::string>& warnings
    );

    void step();
    void say(const std::string& text); ///< as it is; nothing where it is empty
    void finish();

private:
    void printTimes() const;
    void printProfile() const;
    double cpuSeconds() const;

    const Controls& time_;
    const Scene& scene_;
    const WeaklyCompressible& solver_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    double beginTime_ = 0;
    long beginIndex_ = 0;
    double nextReport_ = 0;
    ProgressLine progress_;
};

} // namespace slosh
