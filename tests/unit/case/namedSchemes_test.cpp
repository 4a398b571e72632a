// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/namedSchemes.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class SchemeOfACase : public testing::Test
{
protected:
    void SetUp() override
    {
        root = fs::temp_directory_path() / ("slosh.schemes." + std::to_string(::getpid()));
        fs::create_directories(root / "constant");
        fs::create_directories(root / "system");
    }
    void TearDown() override { fs::remove_all(root); }

    void write(const std::string& file, const std::string& text) const { writeFile(root / file, text); }
    std::string valueOf(const std::string& file, const std::string& path) const
    {
        return Case(root).dictionaryIfPresent(file).textAt(path);
    }

    fs::path root;
};

TEST_F(SchemeOfACase, IsTheRecommendedOneWhereTheCaseNamesNone)
{
    EXPECT_EQ(Case(root).scheme().name, "recommended");
    for (const NamedScheme& scheme : namedSchemes())
    {
        write("system/sphSchemes", "scheme " + scheme.name + ";");
        for (const SchemeEntry& entry : scheme.entries)
        {
            EXPECT_EQ(valueOf(entry.file, entry.path), entry.value) << scheme.name << " " << entry.path;
        }
    }
}

TEST_F(SchemeOfACase, GivesWayToWhatTheCaseSaysInAnyFile)
{
    write("system/sphSchemes", "scheme cao2014; densityDiffusion { type Fourtakas; }");
    write("constant/fluidProperties", "rho0 1000; viscosity { alpha 0.01; }");
    EXPECT_EQ(valueOf("constant/fluidProperties", "viscosity/alpha"), "0.01");
    EXPECT_EQ(valueOf("constant/fluidProperties", "viscosity/type"), "artificial");
    EXPECT_EQ(valueOf("constant/fluidProperties", "viscosity/walls"), "noSlip");
    EXPECT_EQ(valueOf("system/sphSchemes", "densityDiffusion/type"), "Fourtakas");
    EXPECT_EQ(valueOf("system/sphSchemes", "timeIntegration"), "predictorCorrector");

    // The log says where each part stands.
    const auto parts = Case(root).schemeParts();
    const auto has = [&](const std::string& part) { return std::count(parts.begin(), parts.end(), part) == 1; };
    EXPECT_TRUE(has("viscosity/alpha 0.01 (constant/fluidProperties:1)"));
    EXPECT_TRUE(has("kernel improvedGaussian (scheme cao2014)"));
}

TEST_F(SchemeOfACase, LeavesOutWhatGoesWithAPartThatTheCaseHasReplaced)
{
    write("constant/fluidProperties", "rho0 1000; viscosity { type laminar; nu 1e-6; }");
    write("system/sphSchemes", "timeIntegration predictorCorrector;");
    EXPECT_EQ(valueOf("constant/fluidProperties", "viscosity/alpha"), "");
    EXPECT_EQ(valueOf("constant/fluidProperties", "viscosity/walls"), "slip");
    EXPECT_EQ(valueOf("system/controlDict", "maxCo"), ""); // beyond the predictor-corrector's limit
    write("system/sphSchemes", "scheme smallWaves;");
    write("constant/kernelProperties", "kernel quinticSpline;");
    EXPECT_EQ(valueOf("constant/kernelProperties", "hOverDx"), "");
}

TEST_F(SchemeOfACase, OfAnUnknownNameIsRefusedWithTheNearest)
{
    write("system/sphSchemes", "\nscheme cao2O14;");
    try
    {
        Case(root).dictionary("system/sphSchemes");
        FAIL();
    }
    catch (const CaseError& error)
    {
        const std::string message = error.what();
        EXPECT_NE(message.find("did you mean 'cao2014'"), std::string::npos) << message;
        EXPECT_NE(message.find("system/sphSchemes:2"), std::string::npos) << message;
    }
}

} // namespace
} // namespace slosh
