// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the source: includes go downward only, and packages stay where they belong.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

/// A layer and the ones it may include, itself left out.
const std::map<std::string, std::set<std::string>>& layers()
{
    static const std::set<std::string> low = {"base", "dictionary"};
    static const auto with = [](std::set<std::string> all, const std::set<std::string>& more)
    {
        all.insert(more.begin(), more.end());
        return all;
    };
    static const auto fluid = with(low, {"motion", "geometry"});
    static const auto particles = with(fluid, {"case", "fluid"});
    static const auto neighbours = with(particles, {"particles"});
    static const auto scene = with(fluid, {"case", "fluid", "kernels", "viscosities"});
    static const auto physics = with(neighbours, {"neighbours", "kernels", "viscosities"});
    static const auto integration = with(physics, {"physics"});
    static const std::map<std::string, std::set<std::string>> table = {
        {"base", {}},
        {"dictionary", {"base"}},
        {"case", low},
        {"motion", low},
        {"geometry", low},
        {"fluid", fluid},
        {"particles", particles},
        {"filling", neighbours},
        {"neighbours", neighbours},
        {"kernels", low},
        {"viscosities", with(low, {"fluid"})},
        {"scene", scene},
        {"physics", physics},
        {"integration", integration},
        {"solver", with(integration, {"integration", "scene"})},
        {"sampling", with(integration, {"scene"})},
        {"statistics", low},
        {"verification", {"base"}},
        {"vtk", neighbours}};
    return table;
}

struct Include
{
    fs::path file;
    std::string name; ///< what stands between the brackets or quotes
};

std::vector<Include> includesBelow(const std::string& folder)
{
    static const std::regex line(R"(^\s*#include\s*[<"]([^>"]+)[>"])");
    std::vector<Include> includes;
    for (const auto& item : fs::recursive_directory_iterator(fs::path(SLOSH_SOURCE) / folder))
    {
        if (item.path().extension() != ".cpp" && item.path().extension() != ".hpp")
        {
            continue;
        }
        std::ifstream in(item.path());
        std::smatch match;
        for (std::string text; std::getline(in, text);)
        {
            if (std::regex_search(text, match, line))
            {
                includes.push_back({item.path(), match[1]});
            }
        }
    }
    return includes;
}

TEST(Layers, IncludeDownwardOnly)
{
    for (const auto& [layer, below] : layers())
    {
        const auto includes = includesBelow("src/" + layer);
        EXPECT_FALSE(includes.empty()) << layer;
        for (const auto& include : includes)
        {
            const std::string from = include.name.substr(0, include.name.find('/'));
            if (layers().count(from) != 0 && from != layer)
            {
                EXPECT_TRUE(below.count(from) != 0) << include.file << " includes " << include.name;
            }
        }
    }
}

TEST(Layers, AreAllTheFoldersOfTheSource)
{
    std::set<std::string> folders;
    for (const auto& item : fs::directory_iterator(fs::path(SLOSH_SOURCE) / "src"))
    {
        folders.insert(item.path().filename().string());
    }
    std::set<std::string> named;
    for (const auto& layer : layers())
    {
        named.insert(layer.first);
    }
    EXPECT_EQ(folders, named);
}

TEST(Layers, KeepVTKInItsFolderAndProgramOptionsInTheApplications)
{
    for (const auto& include : includesBelow("src"))
    {
        EXPECT_TRUE(include.name.rfind("vtk", 0) != 0 || include.file.parent_path().filename() == "vtk")
            << include.file << " includes " << include.name;
        EXPECT_TRUE(include.name.rfind("boost/", 0) != 0) << include.file << " includes " << include.name;
    }
}

/// The headers of the source that a file includes, and those that these do.
void addIncluded(const fs::path& file, std::set<std::string>& all)
{
    static const std::regex line(R"-(^\s*#include\s*"([^"]+)")-");
    std::ifstream in(file);
    std::smatch match;
    for (std::string text; std::getline(in, text);)
    {
        if (std::regex_search(text, match, line) && all.insert(match[1]).second)
        {
            addIncluded(fs::path(SLOSH_SOURCE) / "src" / match[1].str(), all);
        }
    }
}

TEST(Layers, KeepThePairEngineFromTanksMotionsAndCases)
{
    std::set<std::string> included;
    addIncluded(fs::path(SLOSH_SOURCE) / "src/physics/PairInteractions.hpp", included);
    // The lists of kernels and viscosities are generated. They include all that is in these folders but what reads
    // them.
    for (const std::string folder : {"kernels", "viscosities"})
    {
        for (const auto& type : fs::directory_iterator(fs::path(SLOSH_SOURCE) / "src" / folder))
        {
            const std::string name = type.path().filename();
            if (type.path().extension() == ".hpp" && name != "Kernel.hpp" && name != "readViscosity.hpp")
            {
                addIncluded(type.path(), included);
            }
        }
    }
    EXPECT_EQ(included.count("physics/walk.hpp"), 1);
    for (const std::string& header : included)
    {
        const std::string folder = header.substr(0, header.find('/'));
        EXPECT_NE(header, "kernels/Kernel.hpp");
        EXPECT_NE(header, "viscosities/readViscosity.hpp");
        EXPECT_TRUE(
            folder == "base" || folder == "particles" || folder == "neighbours" || folder == "kernels" ||
            folder == "viscosities" || folder == "physics" || header == "fluid/TaitEquation.hpp" ||
            header == "dictionary/Unit.hpp" || header == "dictionary/Range.hpp" || header == "dictionary/Key.hpp"
        ) << header;
    }
}

TEST(Layers, HoldNoFileOfMoreThanFourHundredLines)
{
    for (const std::string folder : {"src", "applications", "tests", "benchmarks"})
    {
        for (const auto& item : fs::recursive_directory_iterator(fs::path(SLOSH_SOURCE) / folder))
        {
            if (item.is_regular_file())
            {
                std::ifstream in(item.path());
                const auto lines = std::count(std::istreambuf_iterator<char>(in), {}, '\n');
                EXPECT_LE(lines, 400) << item.path();
            }
        }
    }
}

} // namespace
