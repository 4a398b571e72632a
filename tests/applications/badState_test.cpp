// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a time directory that are wrong, disks that are full, rights that are missing, and runs that go wrong.
#include "badInput.hpp"

#include <limits>

#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

using BadState = BadInput;
using BadStateOfSolver = BadInputOfSolver;

// Files of a time directory

TEST_F(BadStateOfSolver, NotANumberInABinaryRestartFileIsNamedWithItsIndex)
{
    std::string text = case_.text("0/lagrangian/fluid/rho");
    const auto begin = text.find('(', text.find("200")) + 1; // after FoamFile's "200("
    const double nan = std::numeric_limits<double>::quiet_NaN();
    text.replace(begin + 7 * sizeof nan, sizeof nan, reinterpret_cast<const char*>(&nan), sizeof nan);
    case_.write("0/lagrangian/fluid/rho", text);
    for (const std::string program : {"sloshSPHFoam", "probeSample", "particlesToVTK"})
    {
        expectRefused(case_, program, {"value number 7", "not a number", "0/lagrangian/fluid/rho"});
    }
}

TEST_F(BadStateOfSolver, NotANumberInAnAsciiRestartFileIsNamedWithItsLine)
{
    case_.edit("system/controlDict", "writeFormat binary", "writeFormat ascii");
    case_.edit("system/controlDict", "writeInterval 0.05", "writeInterval 0.1");
    case_.succeed("sloshSPHFoam -noFunctionObjects");
    std::string text = case_.text("0.1/lagrangian/fluid/p");
    const auto firstValue = text.find("(\n", text.find("200")) + 2;
    text.replace(firstValue, text.find('\n', firstValue) - firstValue, "nan");
    case_.write("0.1/lagrangian/fluid/p", text);
    case_.edit("system/controlDict", "endTime 0.1", "endTime 0.2");
    expectRefused(case_, "sloshSPHFoam", {"value number 0", "not a number", "0.1/lagrangian/fluid/p:"});
}

TEST_F(BadStateOfSolver, TruncatedFileIsRefusedWhereverItEnds)
{
    for (const std::string file : {"positions", "U", "p", "rho", "origId"})
    {
        const std::string name = "0/lagrangian/fluid/" + file;
        const std::string whole = case_.text(name);
        for (const double kept : {0.05, 0.4, 0.9, 0.999})
        {
            case_.write(name, whole.substr(0, static_cast<std::size_t>(kept * static_cast<double>(whole.size()))));
            expectRefused(case_, "sloshSPHFoam", {name});
        }
        case_.write(name, whole);
    }
}

TEST_F(BadStateOfSolver, FieldOfAnotherLengthIsRefused)
{
    case_.write("0/lagrangian/fluid/p", case_.text("0/lagrangian/wall/p"));
    expectRefused(case_, "sloshSPHFoam", {"0/lagrangian/fluid/p: 344 values found", "expected 200"});
}

TEST_F(BadStateOfSolver, MissingFieldIsNamed)
{
    case_.remove("0/lagrangian/wall/rho");
    expectRefused(case_, "sloshSPHFoam", {"0/lagrangian/wall/rho"});
}

// Disks and rights

TEST_F(BadState, FullDiskLeavesNoTimeDirectoryBehind)
{
    // A file larger than 4 blocks, of 512 B or 1 kB, cannot be written, as on a disk that has no more room.
    expectRefused(case_, "blockParticles", {"cannot write", "File too large"}, "trap '' XFSZ; ulimit -f 4;");
}

TEST_F(BadStateOfSolver, FullDiskWhileSamplingStopsTheRun)
{
    fs::create_directories(case_.path() / "postProcessing/pressure/0");
    fs::create_symlink("/dev/full", case_.path() / "postProcessing/pressure/0/p");
    expectMessage(
        case_.run("sloshSPHFoam"), "sloshSPHFoam",
        {"cannot write", "postProcessing/pressure/0/p", "No space left on device"}
    );
}

TEST_F(BadStateOfSolver, FileInPlaceOfTheOutputDirectoryIsRefused)
{
    case_.write("postProcessing", "a file");
    expectRefused(case_, "sloshSPHFoam", {"cannot make the directory", "postProcessing/pressure/0"});
    case_.write("VTK", "a file");
    expectRefused(case_, "particlesToVTK", {"VTK"});
}

TEST_F(BadState, DirectoryWithoutWriteRightIsRefused)
{
    fs::permissions(
        case_.path(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec |
                          fs::perms::group_read | fs::perms::group_exec
    );
    // Rights do not bind root: become somebody else.
    const std::string before = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups" : "";
    if (case_.run("blockParticles -help", before).status != 0)
    {
        GTEST_SKIP() << "the programs cannot be run as another user here";
    }
    expectRefused(case_, "blockParticles", {"Permission denied"}, before);
}

TEST_F(BadState, OutputThatCannotBePrintedIsAnError)
{
    const std::string line =
        "cd '" + case_.path().string() + "' && " SLOSH_BIN "/blockParticles -help > /dev/full 2>&1";
    EXPECT_NE(std::system(line.c_str()), 0);
}

// Runs that go wrong

TEST_F(BadStateOfSolver, UnphysicalRunStopsWithTheLastGoodState)
{
    // Far more than the stable step.
    case_.write("system/sphSchemes", case_.text("system/sphSchemes") + "limits { courantNumber 10; }\n");
    case_.edit("system/controlDict", "adjustTimeStep yes", "adjustTimeStep no");
    case_.edit("system/controlDict", "deltaT 1e-4", "deltaT 5e-3");
    const Ended ended = case_.run("sloshSPHFoam");
    expectMessage(ended, "sloshSPHFoam", {"at t = ", "The last valid state is in the time directory "});
    // What it names is there, and is read.
    const std::string words = "The last valid state is in the time directory ";
    const auto at = ended.err.find(words) + words.size();
    const std::string name = ended.err.substr(at, ended.err.find('\n', at) - at);
    EXPECT_TRUE(fs::exists(case_.path() / name / "lagrangian/fluid/positions")) << name;
    case_.succeed("particlesToVTK -latestTime");
}

TEST_F(BadStateOfSolver, TooTightLimitNamesTheParticleAndItsPlace)
{
    case_.write("system/sphSchemes", "limits { densityDeviation 0.001; }\n");
    expectMessage(
        case_.run("sloshSPHFoam"), "sloshSPHFoam", {"density", "0.1 %", "particle", "kg/m^3", "time directory 0"}
    );
}

} // namespace
} // namespace slosh
