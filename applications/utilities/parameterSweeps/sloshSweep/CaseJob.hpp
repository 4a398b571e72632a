// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseState.hpp"

#include "study/runJobs.hpp"

namespace slosh
{

/// How cases are run.
struct RunOptions
{
    long threads = 1;   ///< of each
    bool retry = false; ///< those that failed are taken up again
};

/// Brings one case to its end from wherever it stands: blockParticles, sloshSPHFoam, compareSamples. What is done is
/// left as it is; a case of other dictionaries is made anew. Says on standard output what became of it.
class CaseJob : public Job
{
public:
    /// Throws CaseError where one of the programs is missing.
    CaseJob(const SweptCase& one, const Sweep& sweep, const RunOptions& options);

    std::optional<Command> next() override;
    void ended(const Ended& how) override;
    void broken(const std::string& why) override;
    void done() override;

private:
    enum class Step
    {
        look,
        fill,
        solve,
        compare,
        nothing
    };

    Step firstStep();
    void makeAnew();
    Command command(const std::string& program) const;
    void fail(const std::string& why);
    void solved(const Ended& how);

    const SweptCase& case_;
    const Sweep& sweep_;
    RunOptions options_;
    Step step_ = Step::look;
    bool ranAnything_ = false;
    Outcome outcome_; ///< as far as the case has come, earlier calls included
    std::string trouble_, remark_;
    std::unique_ptr<FolderLock> lock_;
};

} // namespace slosh
