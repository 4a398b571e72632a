// SPDX-License-Identifier: GPL-3.0-or-later
// Energies of the liquid, and on demand its energy budget.
#include "particles/liquidEnergies.hpp"
#include "sampling/FunctionObject.hpp"
#include "sampling/SampleFile.hpp"

#include <optional>
#include <sstream>

namespace slosh
{

namespace
{

namespace energies
{

constexpr Key budget{
    .name = "budget",
    .otherwise = "no",
    .sentence = "also writes, since the start of the run, the tank's work, the energy taken by viscosity, density "
                "diffusion, walls, re-initialisation and stops at walls, and the residual; costs one pair sum per step "
                "(docs/performance.md); accumulated by sloshSPHFoam only, in <time>/uniform/energyBudget"};

} // namespace energies

class EnergiesFile final : public FunctionObject
{
public:
    static constexpr std::string_view sentence = "Energies of the liquid, [J]: kinetic relative to the tank, kinetic, "
                                                 "potential and internal in the inertial frame";

    explicit EnergiesFile(const FunctionSetting& setting)
        : path_(setting.folder / "energies.dat"), precision_(setting.precision),
          budget_(setting.dict.flag(energies::budget))
    {
    }

    void execute(const Snapshot& snapshot) override
    {
        const Scene& scene = snapshot.scene();
        const TimeState& state = snapshot.state();
        const LiquidEnergies energies = liquidEnergies(
            snapshot.particles(), scene.equationOfState, scene.gravity, snapshot.frame(), scene.tank.thickness()
        );
        const EnergyBudget budget = budget_ ? budgetOf(state, energies) : EnergyBudget();
        if (!file_)
        {
            file_.emplace(path_, header(budget), precision_);
        }
        file_->beginRow(state.time);
        for (const double value : {energies.kineticInTank, energies.kinetic, energies.potential, energies.internal})
        {
            file_->add(value);
        }
        if (budget_)
        {
            for (const double value :
                 {budget.work, budget.positiveWork, budget.viscosity, budget.densityDiffusion, budget.walls,
                  budget.reinitialisation, budget.stops, budget.residual(energies.total())})
            {
                file_->add(value);
            }
        }
        file_->endRow();
    }

    bool wantsBudget() const override { return budget_; }
    std::vector<std::filesystem::path> files() const override { return {path_}; }

private:
    /// That of the snapshot; at the start of a case nothing has been added up.
    EnergyBudget budgetOf(const TimeState& state, const LiquidEnergies& energies) const
    {
        if (state.budget)
        {
            return *state.budget;
        }
        if (state.index != 0)
        {
            std::ostringstream message;
            message << "the state at t = " << state.time
                    << " s has no energy budget (uniform/energyBudget); expected a run with budget yes in the function "
                       "energies of system/controlDict";
            throw CaseError(message.str());
        }
        EnergyBudget fresh;
        fresh.since = state.time;
        fresh.initial = energies.total();
        return fresh;
    }

    std::string header(const EnergyBudget& budget) const
    {
        std::ostringstream text;
        text << "# " << sentence << "\n";
        std::vector<std::string> names = {"kineticInTank", "kinetic", "potential", "internal"};
        if (budget_)
        {
            text.precision(10);
            text << "# Accumulated since t = " << budget.since
                 << " s: work of the tank and its positive part; energy taken from the liquid by viscosity, density "
                    "diffusion, wall particles, re-initialisation of the density, stops at walls\n# residual = kinetic "
                    "+ potential + internal - their initial sum - work + energy taken\n";
            for (const char* name :
                 {"work", "positiveWork", "viscosity", "diffusion", "walls", "reinitialised", "stops", "residual"})
            {
                names.emplace_back(name);
            }
        }
        text << timeColumn("Time");
        for (const auto& name : names)
        {
            text << sampleColumn(name);
        }
        text << "\n";
        return text.str();
    }

    std::filesystem::path path_;
    int precision_;
    bool budget_;
    std::optional<SampleFile> file_;
};

std::unique_ptr<FunctionObject> makeEnergies(const FunctionSetting& setting)
{
    return std::make_unique<EnergiesFile>(setting);
}

} // namespace

namespace choices
{
extern const FunctionObject::Choice energies = {
    "energies", EnergiesFile::sentence, makeEnergies, [] { return Keys{energies::budget}; }};
}

} // namespace slosh
