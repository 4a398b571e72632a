// ParaView's own OpenFOAM reader on our cases. It is in the folder named by SLOSH_PARAVIEW, else in build/paraview
// (etc/unpackParaview puts it there).
#include "installed.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// The command that runs a script in ParaView; empty where there is none.
std::string pvpython()
{
    const char* named = std::getenv("SLOSH_PARAVIEW");
    const fs::path root = named != nullptr ? named : SLOSH_SOURCE "/build/paraview";
    const fs::path program = root / "usr/bin/pvpython3.11";
    if (!fs::exists(program))
    {
        return "";
    }
    return "/usr/bin/env LD_LIBRARY_PATH=\"" + (root / "usr/lib/x86_64-linux-gnu").string() + "\" PYTHONPATH=\"" +
           (root / "usr/lib/python3/dist-packages").string() + "\" \"" + program.string() + "\"";
}

std::string foamFileOf(const CaseDirectory& theCase)
{
    return (theCase.path() / theCase.path().filename()).string() + ".foam";
}

TEST(ParaView, OpensOurCasesAsciiAndBinaryAndShowsEveryParticleWithItsValues)
{
    if (pvpython().empty())
    {
        GTEST_SKIP() << "NOT TESTED: ParaView is not there (etc/unpackParaview build/paraview)";
    }
    const WrittenCase ascii("ascii"), binary("binary");
    const std::string read =
        succeedInShell(ascii, pvpython() + " \"" SLOSH_SOURCE "/tests/applications/paraviewParticles.py\" " +
                                  foamFileOf(ascii) + " " + foamFileOf(binary));
    std::istringstream lines(read);
    for (const CaseDirectory* theCase :
         {static_cast<const CaseDirectory*>(&ascii), static_cast<const CaseDirectory*>(&binary)})
    {
        for (const std::string time : {"0", "0.05", "0.1"})
        {
            std::string line, word, name;
            std::getline(lines, line);
            std::istringstream head(line);
            double shown = -1;
            std::size_t n = 0;
            head >> word >> name >> word >> shown >> word >> n;
            EXPECT_EQ(name, foamFileOf(*theCase)) << line;
            EXPECT_EQ(shown, std::stod(time)) << line;
            ASSERT_EQ(n, 200u) << line;
            std::string values;
            for (std::size_t i = 0; i < n && std::getline(lines, line); ++i)
            {
                values += line + "\n";
            }
            expectOurParticles(*theCase, time, "fluid", rowsOf(values));
        }
    }
    EXPECT_EQ(lines.peek(), std::istringstream::traits_type::eof()) << "ParaView shows more times than we have written";
}

} // namespace
} // namespace slosh
