// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM's own programs (Debian's package openfoam) on our files: foamDictionary, foamListTimes, foamToVTK.
#include "installed.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class OpenFOAM : public testing::Test
{
protected:
    void SetUp() override
    {
        for (const std::string program : {"foamDictionary", "foamListTimes", "foamToVTK"})
        {
            if (!isInstalled(program))
            {
                GTEST_SKIP() << "NOT TESTED: " << program << " is not installed (Debian package openfoam)";
            }
        }
    }
};

std::string contentOf(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The dictionaries that we ship, without what an earlier run has written into a tutorial.
std::vector<fs::path> shippedDictionaries()
{
    std::vector<fs::path> files;
    for (const std::string folder : {"tutorials", "etc", "tests/stability/base"})
    {
        for (auto item = fs::recursive_directory_iterator(fs::path(SLOSH_SOURCE) / folder);
             item != fs::recursive_directory_iterator(); ++item)
        {
            const std::string name = item->path().filename().string();
            if (item->is_directory() && (name == "polyMesh" || name == "runs" || name == "postProcessing"))
            {
                item.disable_recursion_pending();
                continue;
            }
            const std::string parent = item->path().parent_path().filename().string();
            const bool dictionary = parent == "constant" || parent == "system" || parent == "presets";
            // Tables of a motion are no dictionaries, and lie there only once Allrun has fetched them.
            const bool table = name == "roll.dat" || name == "measuredRoll";
            // What blockParticles writes for foamToVTK is not shipped, and lies there once Allrun has run.
            const bool written = (name == "fvSchemes" || name == "fvSolution") &&
                                 fs::exists(item->path().parent_path() / "blockParticlesDict");
            if (item->is_regular_file() && dictionary && !table && !written && item->file_size() > 0)
            {
                files.push_back(item->path());
            }
        }
    }
    return files;
}

/// Expects the same entries with the same words and, to 15 digits, numbers. Returns how many values were compared.
int expectSame(const Dictionary& ours, const Dictionary& theirs)
{
    EXPECT_EQ(ours.keys(), theirs.keys()) << ours.name();
    if (ours.keys() != theirs.keys())
    {
        return 0;
    }
    int compared = 0;
    for (const std::string& key : ours.keys())
    {
        const std::string place = ours.name() + "/" + key;
        EXPECT_EQ(ours.isDict(key), theirs.isDict(key)) << place;
        if (ours.isDict(key) && theirs.isDict(key))
        {
            compared += expectSame(ours.dict(key), theirs.dict(key));
            continue;
        }
        const auto& a = ours.tokens(key);
        const auto& b = theirs.tokens(key);
        EXPECT_EQ(a.size(), b.size()) << place;
        for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k, ++compared)
        {
            EXPECT_EQ(a[k].kind, b[k].kind) << place << ": " << a[k].text << " and " << b[k].text;
            if (a[k].kind == Token::Kind::number)
            {
                EXPECT_NEAR(a[k].number, b[k].number, 1e-15 * std::abs(a[k].number)) << place;
            }
            else
            {
                EXPECT_EQ(a[k].text, b[k].text) << place;
            }
        }
    }
    return compared;
}

/// foamDictionary writes out what it has understood, macros, includes and expressions resolved; we read that and our
/// own file. So each program understands the dictionary, both the same, and ours understands what the other writes.
TEST_F(OpenFOAM, ReadsEveryDictionaryWeShipAsWeDoAndWeReadWhatItWrites)
{
    ASSERT_EQ(setenv("SLOSH_ETC", SLOSH_SOURCE "/etc", 1), 0);
    const CaseDirectory theCase;
    std::vector<fs::path> files;
    std::set<fs::path> included;
    const std::vector<fs::path> shipped = shippedDictionaries();
    for (const fs::path& file : shipped)
    {
        std::istringstream lines(contentOf(file));
        for (std::string word, name; lines >> word;)
        {
            if (word == "#include" && lines >> name)
            {
                included.insert(file.parent_path() / name.substr(1, name.size() - 2));
            }
        }
    }
    std::string commands;
    for (const fs::path& file : shipped)
    {
        // A part without a header may need the macros of the file that includes it: it is read with that.
        if (contentOf(file).find("FoamFile") == std::string::npos && included.count(file) > 0)
        {
            continue;
        }
        commands +=
            "foamDictionary -expand -precision 17 \"" + file.string() + "\" > " + std::to_string(files.size()) + "\n";
        files.push_back(file);
    }
    theCase.write("commands", commands);
    succeedInShell(theCase, "xargs -P 2 -d \"\\n\" -I {} sh -c {} < commands");
    int compared = 0;
    for (std::size_t k = 0; k < files.size(); ++k)
    {
        const std::string name = files[k].lexically_relative(SLOSH_SOURCE).string();
        const int values =
            expectSame(Dictionary::read(files[k], name), Dictionary::read(theCase.path() / std::to_string(k), name));
        EXPECT_GT(values, 0) << name;
        compared += values;
    }
    EXPECT_GT(files.size(), 150u);
    EXPECT_GT(compared, 3000);
}

TEST_F(OpenFOAM, ReadsTheDictionariesThatOurProgramsWrite)
{
    const WrittenCase theCase("binary");
    for (const std::string file :
         {"system/fvSchemes", "system/fvSolution", "0/uniform/time", "0.1/uniform/time", "0.1/uniform/tankState",
          "0.1/uniform/energyBudget", "0.1/uniform/lagrangian/fluid/cloudProperties",
          "0.1/uniform/lagrangian/wall/cloudProperties"})
    {
        std::string keys = "FoamFile\n";
        for (const std::string& key : Dictionary::read(theCase.path() / file, file).keys())
        {
            keys += key + "\n";
        }
        EXPECT_EQ(succeedInShell(theCase, "foamDictionary " + file + " -keywords"), keys) << file;
    }
    EXPECT_EQ(succeedInShell(theCase, "foamDictionary 0.1/uniform/time -entry value -value"), "0.1\n");
    EXPECT_EQ(succeedInShell(theCase, "foamDictionary 0.1/uniform/time -entry name -value"), "\"0.1\"\n");
    EXPECT_EQ(
        succeedInShell(
            theCase, "foamDictionary 0/uniform/lagrangian/fluid/cloudProperties "
                     "-entry processor0/particleCount -value"
        ),
        "200\n"
    );
    EXPECT_EQ(succeedInShell(theCase, "foamDictionary 0.1/uniform/tankState -entry frame -value"), "tank\n");
}

TEST_F(OpenFOAM, ChangesEntriesAndOurProgramsObey)
{
    const CaseDirectory theCase;
    // As users write it: the samples in a file of their own, an angle by a macro.
    const std::string control = theCase.text("system/controlDict");
    const auto functions = control.find("functions");
    theCase.write(
        "system/probesDict",
        control.substr(control.find('{', functions) + 1, control.rfind('}') - control.find('{', functions) - 1)
    );
    theCase.write(
        "system/controlDict", control.substr(0, functions) + "functions\n{\n    #include \"probesDict\"\n}\n"
    );
    theCase.edit(
        "constant/dynamicMeshDict", "    amplitude (8 0 0);", "    angle 8; amplitude ($angle 0 0); #remove angle"
    );

    const std::string motion = "foamDictionary constant/dynamicMeshDict -entry oscillatingRotatingMotionCoeffs/";
    EXPECT_EQ(succeedInShell(theCase, "foamDictionary system/controlDict -entry endTime -value"), "0.1\n");
    EXPECT_EQ(succeedInShell(theCase, motion + "omega -value"), "8\n");
    succeedInShell(theCase, "foamDictionary system/controlDict -entry endTime -set 0.02");
    succeedInShell(theCase, "foamDictionary system/controlDict -entry writeInterval -set 0.01");
    succeedInShell(theCase, "foamDictionary system/controlDict -entry functions/pressure/writeInterval -set 0.005");
    succeedInShell(theCase, motion + "omega -set 6");
    succeedInShell(theCase, "foamDictionary constant/fluidProperties -entry rho0 -set \"[1 -3 0 0 0 0 0] 998\"");
    succeedInShell(theCase, "foamDictionary system/blockParticlesDict -entry particleSpacing -set 0.02");
    succeedInShell(theCase, "foamDictionary system/sphSchemes -entry densityDiffusion -add \"{ type Fourtakas; }\"");

    EXPECT_NE(succeedInShell(theCase, "blockParticles").find("Liquid particles: 50\n"), std::string::npos);
    const std::string log = succeedInShell(theCase, "sloshSPHFoam");
    for (const std::string words :
         {"amplitude (8 0 0) deg, omega 6 rad/s", "density diffusion Fourtakas", "Time = 0.02\n", "\nEnd\n"})
    {
        EXPECT_NE(log.find(words), std::string::npos) << words << "\n" << log;
    }
    EXPECT_EQ(succeedInShell(theCase, "foamListTimes"), "0.01\n0.02\n");
    const std::string state = theCase.text("0/uniform/tankState");
    const double mass = std::stod(state.substr(state.find("mass ") + 5));
    EXPECT_NEAR(50 * mass, 998 * 0.2 * 0.1, 1e-12);
    std::istringstream samples(theCase.text("postProcessing/pressure/0/p"));
    int rows = 0;
    for (std::string line; std::getline(samples, line);)
    {
        rows += line.find('#') == std::string::npos;
    }
    EXPECT_EQ(rows, 5) << "every 0.005 s to 0.02 s";
}

TEST_F(OpenFOAM, ListsExactlyOurTimes)
{
    const CaseDirectory theCase;
    theCase.edit("system/controlDict", "writeInterval 0.05", "writeInterval 0.0125");
    theCase.succeed("blockParticles");
    EXPECT_EQ(succeedInShell(theCase, "foamListTimes -withZero"), "0\n");
    theCase.succeed("sloshSPHFoam");
    EXPECT_EQ(
        succeedInShell(theCase, "foamListTimes -withZero"),
        "0\n0.0125\n0.025\n0.0375\n0.05\n0.0625\n0.075\n0.0875\n0.1\n"
    );
    EXPECT_EQ(succeedInShell(theCase, "foamListTimes -latestTime"), "0.1\n");
}

/// The bytes that base64 stands for.
std::string decoded(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int held = 0;
    for (const char c : text)
    {
        const auto digit = digits.find(c);
        if (digit != std::string::npos)
        {
            bits = bits << 6 | static_cast<unsigned>(digit);
            held += 6;
            if (held >= 8)
            {
                held -= 8;
                bytes += static_cast<char>(bits >> held & 255u);
            }
        }
    }
    return bytes;
}

/// The values of <DataArray ... Name='p' ...>: 8 bytes that say how long they are, then numbers of 4 bytes.
template <class T>
std::vector<T> arrayOf(const std::string& vtp, const std::string& name)
{
    const auto begin = vtp.find('>', vtp.find("Name='" + name + "'")) + 1;
    const std::string bytes = decoded(vtp.substr(begin, vtp.find('<', begin) - begin));
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);
    EXPECT_EQ(bytes.size(), sizeof length + length) << name;
    std::vector<T> values((bytes.size() - sizeof length) / sizeof(T));
    std::memcpy(values.data(), bytes.data() + sizeof length, values.size() * sizeof(T));
    return values;
}

ParticleRows particlesOf(const std::string& vtp)
{
    const auto x = arrayOf<float>(vtp, "Points"), U = arrayOf<float>(vtp, "U"), p = arrayOf<float>(vtp, "p"),
               rho = arrayOf<float>(vtp, "rho");
    const auto id = arrayOf<std::int32_t>(vtp, "origId");
    ParticleRows rows;
    for (std::size_t i = 0; i < id.size(); ++i)
    {
        rows.push_back(
            {x.at(3 * i), x.at(3 * i + 1), x.at(3 * i + 2), U.at(3 * i), U.at(3 * i + 1), U.at(3 * i + 2), p.at(i),
             rho.at(i), static_cast<double>(id[i])}
        );
    }
    return rows;
}

class OpenFOAMOnWritten : public OpenFOAM, public testing::WithParamInterface<std::string>
{
};

TEST_P(OpenFOAMOnWritten, ExportsEveryParticleOfOursWithItsValues)
{
    const WrittenCase theCase(GetParam());
    succeedInShell(theCase, "foamToVTK");
    for (const std::string time : {"0", "0.05", "0.1"})
    {
        const long index = Dictionary::read(theCase.path() / time / "uniform/time", "time").label("index");
        for (const std::string cloud : {"fluid", "wall"})
        {
            const std::string file = "VTK/lagrangian/" + cloud + "/" + cloud + "_" + std::to_string(index) + ".vtp";
            // OpenFOAM keeps positions relative to the cell's corners and puts them together again.
            expectOurParticles(theCase, time, cloud, particlesOf(theCase.text(file)), 1e-15);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    As, OpenFOAMOnWritten, testing::Values("ascii", "binary"), [](const auto& tested) { return tested.param; }
);

} // namespace
} // namespace slosh
