// SPDX-License-Identifier: GPL-3.0-or-later
// ParaView on our cases: its own OpenFOAM reader, and our script that shows them. It is in the folder named by
// SLOSH_PARAVIEW, else in build/paraview (etc/unpackParaview puts it there).
#include "installed.hpp"
#include "samples.hpp"

#include "case/foamFile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
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
           (root / "usr/lib/python3/dist-packages").string() + "\" \"" + program.string() + "\" --no-mpi";
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
    const std::string read = succeedInShell(
        ascii, pvpython() + " \"" SLOSH_SOURCE "/tests/applications/paraviewParticles.py\" " + foamFileOf(ascii) + " " +
                   foamFileOf(binary)
    );
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

/// The words of the line of `said` that begins with `key`.
std::vector<std::string> wordsOf(const std::string& said, const std::string& key)
{
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
    {
        if (line.rfind(key + " ", 0) == 0)
        {
            std::istringstream words(line.substr(key.size()));
            return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
        }
    }
    ADD_FAILURE() << "no " << key << " in\n" << said;
    return {};
}

TEST(ParaView, ShowsACaseByOurScriptColouredByPressureWithTankSurfaceAndScale)
{
    if (pvpython().empty() || !isInstalled("xvfb-run"))
    {
        GTEST_SKIP() << "NOT TESTED: ParaView (etc/unpackParaview build/paraview) or xvfb-run "
                        "(etc/install-dependencies test) is "
                        "not there";
    }
    const WrittenCase theCase("binary");
    theCase.succeed("particlesToVTK -surface");
    const Ended ended = runInShell(
        theCase, "xvfb-run -a -s \"-screen 0 800x600x24 -noreset\" " + pvpython() +
                     " \"" SLOSH_SOURCE "/tests/applications/paraviewPipeline.py\" \"" SLOSH_SOURCE
                     "/etc/paraview/showCase.py\" --time 0.06 --size 500x320 --png seen.png --animation frames.png"
    );
    ASSERT_EQ(ended.status, 0) << ended.out << ended.err;

    EXPECT_EQ(wordsOf(ended.out, "points"), std::vector<std::string>{"200"});
    EXPECT_EQ(wordsOf(ended.out, "array"), (std::vector<std::string>{"POINTS", "p"}));
    EXPECT_EQ(wordsOf(ended.out, "title"), (std::vector<std::string>{"pressure", "[Pa]"}));
    EXPECT_EQ(
        wordsOf(ended.out, "shows"), (std::vector<std::string>{"free_surface", "liquid", "tank", "time", "walls"})
    );

    // The colours go up to the hundredth highest pressure of any time, rounded up to two digits.
    double highest = 0;
    for (const std::string time : {"0", "0.05", "0.1"})
    {
        auto p = readScalarField(theCase.path(), time + "/lagrangian/fluid/p");
        std::sort(p.begin(), p.end());
        highest = std::max(highest, p.at(197)); // 0.99*199
    }
    const auto colours = wordsOf(ended.out, "colours");
    ASSERT_EQ(colours.size(), 2u);
    EXPECT_EQ(std::stod(colours[0]), 0);
    EXPECT_GE(std::stod(colours[1]), highest);
    EXPECT_LE(std::stod(colours[1]), highest + std::pow(10, std::floor(std::log10(highest)) - 1));

    // From the front: y to the right, z up.
    const auto camera = wordsOf(ended.out, "camera");
    ASSERT_EQ(camera.size(), 9u);
    EXPECT_GT(std::stod(camera[3]), std::stod(camera[0]) + 0.2);
    EXPECT_EQ(std::stod(camera[4]), std::stod(camera[1]));
    EXPECT_EQ(std::stod(camera[8]), 1);

    const auto picture = wordsOf(ended.out, "picture");
    ASSERT_EQ(picture.size(), 8u);
    EXPECT_EQ(picture[0] + "x" + picture[1], "500x320");
    EXPECT_GT(std::stod(picture[3]), 0.15) << "white";
    EXPECT_GT(std::stod(picture[5]), 0.05) << "walls, outline, writing";
    EXPECT_GT(std::stod(picture[7]), 0.1) << "liquid and scale";

    for (const std::string file : {"frames.0000.png", "frames.0001.png", "frames.0002.png"})
    {
        EXPECT_GT(theCase.text(file).size(), 5000u) << file;
    }
    EXPECT_NE(theCase.text("frames.0000.png"), theCase.text("frames.0002.png"));
    EXPECT_FALSE(fs::exists(theCase.path() / "frames.0003.png"));
}

TEST(ParaView, IsToldByOurScriptWhatIsMissing)
{
    if (pvpython().empty())
    {
        GTEST_SKIP() << "NOT TESTED: ParaView is not there (etc/unpackParaview build/paraview)";
    }
    const CaseDirectory theCase;
    const Ended ended = runInShell(theCase, pvpython() + " \"" SLOSH_SOURCE "/etc/paraview/showCase.py\" --png a.png");
    EXPECT_EQ(ended.status, 1);
    EXPECT_NE(ended.err.find("there is no ./VTK/fluid.vtu.series: particlesToVTK makes it"), std::string::npos)
        << ended.err;
}

} // namespace
} // namespace slosh
