// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that are wrong, and what a program must say of them.
#pragma once

#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slosh
{

using Fragments = std::vector<std::string>;

inline void expectMessage(const Ended& ended, const std::string& command, const Fragments& fragments)
{
    EXPECT_EQ(ended.status, 1) << command << "\n" << ended.err;
    EXPECT_EQ(ended.err.find("\n--> FOAM FATAL"), 0u) << command << "\n" << ended.err;
    EXPECT_EQ(ended.out.find("\nEnd\n"), std::string::npos) << command;
    for (const auto& fragment : fragments)
    {
        EXPECT_NE(ended.err.find(fragment), std::string::npos) << command << " does not say " << fragment << " but\n"
                                                               << ended.err;
    }
}

inline void expectRefused(
    const CaseDirectory& theCase, const std::string& command, const Fragments& fragments, const std::string& before = ""
)
{
    const auto untouched = theCase.tree();
    expectMessage(theCase.run(command, before), command, fragments);
    EXPECT_EQ(theCase.tree(), untouched) << command;
}

class BadInput : public testing::Test
{
protected:
    CaseDirectory case_;
};

/// A case that blockParticles has filled.
class BadInputOfSolver : public BadInput
{
protected:
    void SetUp() override { case_.succeed("blockParticles"); }
};

} // namespace slosh
