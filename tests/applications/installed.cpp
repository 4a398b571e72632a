// SPDX-License-Identifier: GPL-3.0-or-later
#include "installed.hpp"

#include "case/foamFile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace slosh
{

namespace
{

/// Expects `read` to be the single-precision number nearest to `ours`, `moved` aside from it at most.
void expectNearestFloat(double read, double ours, double moved, const std::string& what)
{
    const auto nearest = static_cast<float>(ours);
    const double half =
        (std::nextafter(std::abs(nearest), std::numeric_limits<float>::infinity()) - std::abs(nearest)) / 2;
    EXPECT_LE(std::abs(read - ours), half + moved) << what << ": " << read << ", not " << ours;
}

} // namespace

bool isInstalled(const std::string& program)
{
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

Ended runInShell(const CaseDirectory& theCase, const std::string& commands)
{
    EXPECT_EQ(commands.find('\''), std::string::npos) << commands;
    return theCase.run(
        "/bin/bash -c 'set -e; . \"" SLOSH_SOURCE "/etc/bashrc\"; PATH=\"" SLOSH_BIN ":$PATH\"; " + commands + "'"
    );
}

std::string succeedInShell(const CaseDirectory& theCase, const std::string& commands)
{
    const Ended ended = runInShell(theCase, commands);
    EXPECT_EQ(ended.status, 0) << commands << "\n" << ended.out << ended.err;
    EXPECT_EQ(ended.err, "") << commands;
    return ended.out;
}

WrittenCase::WrittenCase(const std::string& format)
{
    edit("system/controlDict", "writeFormat binary", "writeFormat " + format);
    succeed("blockParticles");
    succeed("sloshSPHFoam");
}

void expectOurParticles(
    const CaseDirectory& theCase, const std::string& time, const std::string& cloud, const ParticleRows& read,
    double moved
)
{
    const std::string folder = time + "/lagrangian/" + cloud + "/";
    const auto positions = readPositions(theCase.path(), folder + "positions");
    const auto U = readVectorField(theCase.path(), folder + "U");
    const auto p = readScalarField(theCase.path(), folder + "p");
    const auto rho = readScalarField(theCase.path(), folder + "rho");
    const auto id = readLabelField(theCase.path(), folder + "origId");
    ASSERT_EQ(read.size(), positions.size()) << folder;
    for (std::size_t i = 0; i < read.size(); ++i)
    {
        const std::string particle = folder + " particle " + std::to_string(i) + " ";
        ASSERT_EQ(read[i].size(), 9u) << particle;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto axis = static_cast<Eigen::Index>(k);
            expectNearestFloat(read[i][k], positions[i][axis], moved, particle + "xyz"[k]);
            expectNearestFloat(read[i][3 + k], U[i][axis], 0, particle + "U" + "xyz"[k]);
        }
        expectNearestFloat(read[i][6], p[i], 0, particle + "p");
        expectNearestFloat(read[i][7], rho[i], 0, particle + "rho");
        EXPECT_EQ(read[i][8], id[i]) << particle;
    }
}

} // namespace slosh
