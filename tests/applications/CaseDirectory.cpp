// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

std::string readAll(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string foamFile(const std::string& object, const std::string& className = "dictionary")
{
    return "FoamFile { version 2.0; format ascii; class " + className + "; object " + object + "; }\n";
}

} // namespace

CaseDirectory::CaseDirectory()
{
    std::string name = (fs::temp_directory_path() / "sloshCaseXXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
    {
        throw std::runtime_error("cannot make a temporary directory");
    }
    path_ = name;
    write(
        "constant/g",
        foamFile("g", "uniformDimensionedVectorField") + "dimensions [0 1 -2 0 0 0 0];\nvalue (0 0 -9.81);\n"
    );
    write(
        "constant/tankProperties",
        foamFile("tankProperties") + "plane yz;\nmin (-0.5 -0.1 0);\nmax (0.5 0.1 0.15);\nfillDepth 0.1;\n"
    );
    write(
        "constant/fluidProperties",
        foamFile("fluidProperties") + "rho0 [1 -3 0 0 0 0 0] 1000;\nviscosity { type artificial; alpha 0.03; }\n"
    );
    write("constant/kernelProperties", foamFile("kernelProperties") + "kernel improvedGaussian;\n");
    write("constant/dynamicMeshDict", foamFile("dynamicMeshDict") + R"(dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolver solidBody;
solidBodyMotionFunction oscillatingRotatingMotion;
oscillatingRotatingMotionCoeffs
{
    origin (0 0 0.1);
    amplitude (8 0 0);
    omega 8;
}
)");
    write("system/blockParticlesDict", foamFile("blockParticlesDict") + "particleSpacing 0.01;\n");
    write("system/sphSchemes", foamFile("sphSchemes") + "scheme cao2014;\nframe tank;\n");
    write("system/controlDict", foamFile("controlDict") + R"(application sloshSPHFoam;
startFrom latestTime;
endTime 0.1;
deltaT 1e-4;
adjustTimeStep yes;
writeControl adjustableRunTime;
writeInterval 0.05;
writeFormat binary;
writePrecision 10;
functions
{
    pressure
    {
        type probes;
        fields (p);
        probeLocations
        (
            (0 -0.1 0.05)
            (0 0.1 0.05)
            (0 0.1 0.14)
        );
        writeControl runTime;
        writeInterval 0.01;
    }
    gauges
    {
        type interfaceHeight;
        locations ((0 0 0));
        writeControl runTime;
        writeInterval 0.01;
    }
    forces
    {
        type forces;
        CofR (0 0 0.1);
        writeControl runTime;
        writeInterval 0.01;
    }
    energies
    {
        type energies;
        budget yes;
        writeControl runTime;
        writeInterval 0.01;
    }
}
)");
}

CaseDirectory::~CaseDirectory()
{
    std::error_code failure;
    fs::permissions(path_, fs::perms::owner_all, failure);
    fs::remove_all(path_, failure);
}

std::string CaseDirectory::text(const std::string& file) const
{
    EXPECT_TRUE(fs::exists(path_ / file)) << file;
    return readAll(path_ / file);
}

void CaseDirectory::write(const std::string& file, const std::string& text) const
{
    fs::create_directories((path_ / file).parent_path());
    std::ofstream(path_ / file, std::ios::binary) << text;
}

void CaseDirectory::remove(const std::string& fileOrFolder) const
{
    EXPECT_GT(fs::remove_all(path_ / fileOrFolder), 0u) << fileOrFolder;
}

void CaseDirectory::edit(const std::string& file, const std::string& from, const std::string& to) const
{
    std::string content = text(file);
    const auto at = content.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
    ASSERT_EQ(content.find(from, at + 1), std::string::npos) << from << " is more than once in " << file;
    write(file, content.replace(at, from.size(), to));
}

std::map<std::string, std::string> CaseDirectory::tree() const
{
    std::map<std::string, std::string> tree;
    for (const auto& item : fs::recursive_directory_iterator(path_))
    {
        const std::string name = item.path().lexically_relative(path_).string();
        tree[name] = item.is_regular_file() ? readAll(item.path()) : "";
    }
    return tree;
}

void CaseDirectory::copyFrom(const CaseDirectory& other) const
{
    fs::remove_all(path_);
    fs::copy(other.path(), path_, fs::copy_options::recursive);
}

Ended CaseDirectory::run(const std::string& command, const std::string& before) const
{
    // What the program prints goes beside the case, so that the case holds only what the program wrote.
    const std::string out = path_.string() + ".out", err = path_.string() + ".err";
    const std::string line = "cd '" + path_.string() + "' && " + before + " " +
                             (command[0] == '.' || command[0] == '/' ? "" : SLOSH_BIN "/") + command + " > '" + out +
                             "' 2> '" + err + "'";
    const int status = std::system(line.c_str());
    const Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readAll(out), readAll(err)};
    fs::remove(out);
    fs::remove(err);
    return ended;
}

std::string CaseDirectory::succeed(const std::string& command) const
{
    const Ended ended = run(command);
    EXPECT_EQ(ended.status, 0) << command << "\n" << ended.err;
    EXPECT_EQ(ended.err, "") << command;
    return ended.out;
}

} // namespace slosh
