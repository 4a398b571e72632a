// SPDX-License-Identifier: GPL-3.0-or-later
#include "slurmScript.hpp"

#include <sstream>

namespace slosh
{

namespace
{

/// A word in the shell's single quotes.
std::string shellQuoted(const std::string& text)
{
    std::string out = "'";
    for (const char c : text)
    {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

} // namespace

std::string
slurmScript(const Sweep& sweep, const std::filesystem::path& caseRoot, const std::string& dictName, long atOnce)
{
    namespace fs = std::filesystem;
    std::error_code failure;
    const fs::path bin = fs::read_symlink("/proc/self/exe", failure).parent_path();
    const fs::path root = fs::canonical(caseRoot);
    const std::string dict = dictName == "system/sweepDict" ? "" : " -dict " + shellQuoted(dictName);
    std::ostringstream out;
    out << "#!/bin/bash\n# Written by sloshSweep -slurm: one task for each of the " << sweep.cases.size()
        << " cases. Finished cases are not run again: submit it\n# again until all are finished. Then write the table "
           "and the map:\n#     sbatch --wait sweep.sbatch; sloshSweep -collect"
        << dict
        << "\n# or in a separate job:\n#     sbatch --dependency=afterany:$(sbatch --parsable sweep.sbatch) --wrap "
           "'sloshSweep -collect"
        << (dict.empty() ? "" : " -dict \"" + dictName + "\"")
        << "'\n"
           "#SBATCH --job-name=sloshSweep\n"
           "#SBATCH --array=1-"
        << sweep.cases.size() << (atOnce > 0 ? "%" + std::to_string(atOnce) : "")
        << "\n#SBATCH --ntasks=1\n"
           "#SBATCH --cpus-per-task="
        << sweep.slurmThreads
        << "\n"
           "#SBATCH --chdir=\""
        << root.string()
        << "\"\n"
           "#SBATCH --output=log.sloshSweep.%a\n"
           "#SBATCH --signal=B:TERM@60\n"; // the solver writes and stops
    for (const auto& option : sweep.slurmOptions)
    {
        out << "#SBATCH " << option << "\n";
    }
    out << "\nPATH=$PATH:" << shellQuoted(bin.string())
        << "\n"
           "exec sloshSweep"
        << dict << " -only \"$SLURM_ARRAY_TASK_ID\" -threads \"$SLURM_CPUS_PER_TASK\"\n";
    return out.str();
}

} // namespace slosh
