// SPDX-License-Identifier: GPL-3.0-or-later
// The quick scenes of tests/stability, each with the bounds it must keep (Allrun, docs/stability.md).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

const fs::path here = fs::path(SLOSH_SOURCE) / "tests/stability";

std::string textOf(const fs::path& file)
{
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// A folder for one test, removed with it.
class Scratch
{
public:
    Scratch()
    {
        std::string name = (fs::temp_directory_path() / "sloshScenesXXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
        {
            throw std::runtime_error("cannot make a temporary directory");
        }
        path_ = name;
    }
    ~Scratch() { fs::remove_all(path_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const fs::path& path() const { return path_; }

    void write(const std::string& file, const std::string& text) const
    {
        fs::create_directories((path_ / file).parent_path());
        std::ofstream(path_ / file) << text;
    }

    /// Runs Allrun into the folder, with the programs that are tested before any other; its exit status, what it said
    /// in log.
    int allrun(const std::string& arguments, std::string& log) const
    {
        const fs::path file = path_ / "log";
        const std::string command = "PATH='" SLOSH_BIN "':\"$PATH\" SLOSH_JOBS=1 '" + (here / "Allrun").string() +
                                    "' -into '" + (path_ / "runs").string() + "' " + arguments + " > '" +
                                    file.string() + "' 2>&1";
        const int status = std::system(command.c_str());
        log = textOf(file);
        return status;
    }

private:
    fs::path path_;
};

TEST(QuickScenes, KeepTheirBoundsOrStopWithTheirWords)
{
    const Scratch scratch;
    std::string log;
    EXPECT_EQ(scratch.allrun("-quick", log), 0) << log;
    EXPECT_TRUE(std::regex_search(log, std::regex("\n2[0-9] scenes, 0 wrong\n$"))) << log;
}

TEST(Scenes, ThatBreakABoundStopOrDoNotStopAreWrong)
{
    const Scratch scratch;
    scratch.write("scenes/bad", R"(group "Bad"
scene broken "a bound that cannot be kept"
with system/controlDict "endTime 0.01;"
keeps outside 0 "sound"
keeps density 1e-9 "nothing is so stiff"
scene stopped "a run that ends early"
with system/controlDict "endTime 1;"
with system/sphSchemes "limits { densityDeviation 1e-6; }"
keeps outside 0 "sound"
scene running "a run that should have stopped"
with system/controlDict "endTime 0.01;"
stops "the step is too long"
scene otherwise "a stop for another reason"
with constant/tankProperties "fillDepth -1;"
stops "the step is too long"
)");
    std::string log;
    EXPECT_NE(scratch.allrun("-scenes '" + (scratch.path() / "scenes").string() + "'", log), 0);
    for (const std::string words :
         {"broken           wrong: density is 0.00", "stopped          wrong: stopped, at t = ",
          "running          wrong: did not stop", "otherwise        wrong: did not stop", "4 scenes, 4 wrong"})
    {
        EXPECT_NE(log.find(words), std::string::npos) << words << " is not in\n" << log;
    }
}

} // namespace
} // namespace slosh
