// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Schedule.hpp"
#include "dictionary/Dictionary.hpp"
#include "sampling/Snapshot.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slosh
{

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
};

/// What a function needs when it is made.
struct FunctionSetting
{
    const Dictionary& dict;
    const Scene& scene;
    std::filesystem::path folder; ///< postProcessing/<name>/<startTime>
    int precision = 6;            ///< digits of values
};

// One source each; each reads its own keys and throws CaseError.
std::unique_ptr<FunctionObject> makeProbes(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeInterfaceHeight(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeForces(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeEnergies(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeCentreOfMass(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeDensityDeviation(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeExtent(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeSemiAxes(const FunctionSetting& setting);
std::unique_ptr<FunctionObject> makeParticlesOutside(const FunctionSetting& setting);

/// Points of `key`, which must lie in the tank, on its walls at most, and outside its bodies.
std::vector<Vec> pointsInTank(const FunctionSetting& setting, const std::string& key);

} // namespace slosh
