// SPDX-License-Identifier: GPL-3.0-or-later
// The tutorial of kernelAccuracy as a case of a test.
#pragma once

#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slosh
{

/// A fresh copy of the tutorial; fewer samples than a figure needs.
class KernelAccuracy : public testing::Test
{
protected:
    const std::string dictionary = "system/kernelAccuracyDict";
    const std::filesystem::path tutorial = std::filesystem::path(SLOSH_SOURCE) / "tutorials/kernelAccuracy/cao2014";

    void SetUp() override
    {
        for (const std::string folder : {"constant", "system"})
        {
            case_.remove(folder);
            std::filesystem::copy(tutorial / folder, case_.path() / folder, std::filesystem::copy_options::recursive);
        }
        case_.edit(dictionary, "samples         1000;", "samples         20;");
    }

    void edit(const std::string& from, const std::string& to) const { case_.edit(dictionary, from, to); }

    void expectRefused(const std::string& from, const std::string& to, const std::vector<std::string>& fragments)
    {
        const std::string before = case_.text(dictionary);
        edit(from, to);
        const auto untouched = case_.tree();
        const Ended ended = case_.run("kernelAccuracy");
        EXPECT_EQ(ended.status, 1) << to;
        EXPECT_EQ(ended.err.find("\n--> FOAM FATAL"), 0u) << ended.err;
        for (const auto& fragment : fragments)
        {
            EXPECT_NE(ended.err.find(fragment), std::string::npos) << fragment << " is not in\n" << ended.err;
        }
        EXPECT_EQ(case_.tree(), untouched) << to;
        case_.write(dictionary, before);
    }

    CaseDirectory case_;
};

} // namespace slosh
