// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "SweepCase.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace slosh
{

namespace fs = std::filesystem;

class SloshSweep : public testing::Test
{
protected:
    static void
    expectRefused(const CaseDirectory& theCase, const std::string& command, const std::vector<std::string>& fragments)
    {
        const Ended ended = theCase.run(command);
        EXPECT_EQ(ended.status, 1);
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << " is not in\n" << ended.err;
        }
        EXPECT_FALSE(fs::exists(theCase.path() / "postProcessing"));
    }

    const SweepCase case_;
};

inline const std::string frequency =
    "frequency { file \"constant/dynamicMeshDict\"; entry "
    "oscillatingRotatingMotionCoeffs.omega; naturalFrequency 1; range (0.8 1.2); count 3; }";
inline const std::string angle =
    "angle { file \"constant/dynamicMeshDict\"; entry oscillatingRotatingMotionCoeffs.amplitude; "
    "direction (1 0 0); values (2 4); unit deg; }";
inline const std::string depth =
    "depth { file \"constant/tankProperties\"; entry fillDepth; values (0.06 0.1); unit m; }";
inline const std::string peak = "peak { samples \"pressure/p\"; column 1; timeStart 0; quantity maximum; unit Pa; }";

} // namespace slosh
