// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Schedule.hpp"
#include "dictionary/Choice.hpp"
#include "sampling/Snapshot.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace slosh
{

struct FunctionSetting;

/// Something sampled while a run goes on, as OpenFOAM's function objects: writes its rows below
/// postProcessing/<name>/<startTime>/.
class FunctionObject
{
public:
    virtual ~FunctionObject() = default;
    virtual void execute(const Snapshot& snapshot) = 0;
    /// Whether its snapshots must hold an energy budget, which the solver keeps only when asked.
    virtual bool wantsBudget() const { return false; }
    /// Files it writes to.
    virtual std::vector<std::filesystem::path> files() const = 0;

    /// A function by its name, `type` in functions of system/controlDict. Its source has the class, the entries it has
    /// beside those of all functions, what makes it of them, which throws CaseError, and this, whose sentence says
    /// which quantity it writes in which unit, and in which file where that is not <name>.dat; CMakeLists.txt lists it.
    using Choice = slosh::Choice<std::unique_ptr<FunctionObject> (*)(const FunctionSetting& setting)>;
    static const std::vector<Choice>& choices();
};

/// What a function needs when it is made.
struct FunctionSetting
{
    const Dictionary& dict;
    const Scene& scene;
    std::filesystem::path folder; ///< postProcessing/<name>/<startTime>
    int precision = 6;            ///< digits of values
};

/// Points of `key`, which must lie in the tank, on its walls at most, and outside its bodies.
std::vector<Vec> pointsInTank(const FunctionSetting& setting, const Key& key);

} // namespace slosh
