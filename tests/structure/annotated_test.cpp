// SPDX-License-Identifier: GPL-3.0-or-later
// etc/annotated has every key that the sources read from a user's dictionaries, and its default as the sources have it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

/// Which annotated dictionaries the reads of a source belong to. None: it reads what programs have written.
const std::map<std::string, Names>& dictionariesOf()
{
    static const Names function = {"system/probesDict"}, fluid = {"constant/fluidProperties"},
                       tank = {"constant/tankProperties"}, comparisons = {"system/comparisonsDict"},
                       study = {"system/workPrecisionDict", "system/comparisonsDict"},
                       sweep = {"system/sweepDict", "system/comparisonsDict"};
    static const std::map<std::string, Names> table = {
        {"src/case/Case.cpp", {"constant/g"}},
        {"src/case/Controls.cpp", {"system/controlDict"}},
        {"src/case/Schedule.cpp", {"system/probesDict", "system/controlDict"}},
        {"src/case/TimeStepControl.cpp", {"system/controlDict"}},
        {"src/case/namedSchemes.cpp", {"system/sphSchemes"}},
        {"src/case/readFoamFile.cpp", {}},
        {"src/geometry", tank},
        {"src/kernels", {"constant/kernelProperties"}},
        {"src/motion", {"constant/dynamicMeshDict"}},
        {"src/fluid/FluidProperties.cpp", fluid},
        {"src/viscosities", fluid},
        {"src/filling/initialFields.cpp", {"system/blockParticlesDict"}},
        {"src/particles/particleFiles.cpp", {}},
        {"src/scene", {"system/sphSchemes"}},
        {"src/sampling", function},
        {"src/sampling/FunctionObjects.cpp", {"system/probesDict", "system/controlDict"}},
        {"src/solver", {"system/sphSchemes"}},
        {"src/statistics", comparisons},
        {"applications/solvers/sloshSPHFoam", {"system/controlDict"}},
        {"applications/study", {"system/sweepDict", "system/workPrecisionDict"}},
        {"applications/study/Outcome.cpp", {}},
        {"applications/utilities/parameterSweeps/sloshSweep", sweep},
        {"applications/utilities/parameterSweeps/sloshSweep/CaseFacts.cpp", {"system/controlDict"}},
        {"applications/utilities/preProcessing/blockParticles", {"system/blockParticlesDict"}},
        {"applications/utilities/preProcessing/foamToSlosh", {}}, // interFoam's
        {"applications/utilities/postProcessing/compareSamples", comparisons},
        {"applications/utilities/postProcessing/peakStatistics", {"system/peakStatisticsDict"}},
        {"applications/utilities/postProcessing/sloshReport", {"system/blockParticlesDict"}},
        {"applications/utilities/verification/kernelAccuracy", {"system/kernelAccuracyDict"}},
        {"applications/utilities/verification/workPrecision", study}};
    return table;
}

std::string readAll(const fs::path& file)
{
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A key that a source asks a dictionary for.
struct Read
{
    std::string source, key;
    std::string otherwise; ///< its default as it would stand in a dictionary; empty: none, or not a plain value
};

const std::string literal = R"-(("[^"]*"|-?[0-9][-+.\w]*|true|false))-";

/// A default as a user writes it. A member's first value is looked up in the headers beside the source.
std::string asInDictionary(const std::string& written, const fs::path& folder)
{
    static const std::map<std::string, std::string> words = {
        {"true", "yes"}, {"false", "no"}, {"Vec::Zero", "(0 0 0)"}, {"Vec::Ones", "(1 1 1)"}};
    if (const auto word = words.find(written); word != words.end())
    {
        return word->second;
    }
    if (std::smatch match; std::regex_match(written, match, std::regex(literal)))
    {
        return written[0] == '"' ? written.substr(1, written.size() - 2) : written;
    }
    if (const auto dot = written.find('.'); dot != std::string::npos)
    {
        const std::regex member("\\b" + written.substr(dot + 1) + " = " + literal + ";");
        for (const auto& item : fs::directory_iterator(folder))
        {
            std::smatch match;
            const std::string text = item.path().extension() == ".hpp" ? readAll(item.path()) : "";
            if (std::regex_search(text, match, member))
            {
                return asInDictionary(match[1], folder);
            }
        }
    }
    return "";
}

void addReads(const fs::path& file, std::vector<Read>& reads)
{
    static const std::regex comment("//[^\n]*");
    static const std::regex read(
        R"((\bprogram\.)?\b(?:(?:scalar|label|flag|word|choice|vector|dict)(?:Or)?|scalars|vectors|planePoints|words|tokens|isDict|has|requireDimensions|choose))"
        R"-(\((?:\w+, )?\s*"(\w+)"(?:\s*,\s*("[^"]*"|[-\w.:]+)(?:\(\))?\s*[,)])?)-"
    );
    static const std::regex list(R"((?:\b(?:allow|ignore)\(\s*|\bkey : )\{([^}]*)\})");
    static const std::regex name(R"-((^|[^+ ]|[^+] )"(\w+)")-");
    const std::string source = file.lexically_relative(SLOSH_SOURCE).string();
    const std::string text = std::regex_replace(readAll(file), comment, "");
    for (std::sregex_iterator match(text.begin(), text.end(), read), end; match != end; ++match)
    {
        if (!(*match)[1].matched) // the command line's
        {
            // A member that was given a value before is no plain one.
            const std::string before = text.substr(0, static_cast<std::size_t>(match->position()));
            const auto given = before.find((*match)[3].str() + " = ");
            const bool isPlain = match->str().find("Or(") != std::string::npos &&
                                 (given == std::string::npos || before.find(';', given) == std::string::npos);
            reads.push_back(
                {source, (*match)[2], isPlain ? asInDictionary((*match)[3], file.parent_path()) : std::string()}
            );
        }
    }
    for (std::sregex_iterator match(text.begin(), text.end(), list), end; match != end; ++match)
    {
        const std::string keys = (*match)[1];
        for (std::sregex_iterator key(keys.begin(), keys.end(), name); key != end; ++key)
        {
            reads.push_back({source, (*key)[2], ""});
        }
    }
}

std::vector<Read> allReads()
{
    std::vector<Read> reads;
    for (const std::string top : {"src", "applications"})
    {
        for (const auto& item : fs::recursive_directory_iterator(fs::path(SLOSH_SOURCE) / top))
        {
            const std::string folder = item.path().parent_path().filename();
            if ((item.path().extension() == ".cpp" || item.path().extension() == ".hpp") && folder != "dictionary" &&
                folder != "common")
            {
                addReads(item.path(), reads);
            }
        }
    }
    return reads;
}

/// The dictionaries of a source: those of the table's longest name for it. Null: it has none.
const Names* dictionariesFor(const std::string& source)
{
    const Names* found = nullptr;
    for (const auto& [name, dictionaries] : dictionariesOf()) // a longer name stands behind the shorter one
    {
        if (source.rfind(name, 0) == 0)
        {
            found = &dictionaries;
        }
    }
    return found;
}

std::string annotated(const std::string& dictionary)
{
    const std::string text = readAll(fs::path(SLOSH_SOURCE) / "etc/annotated" / dictionary);
    EXPECT_NE(text, "") << dictionary;
    return text.substr(text.find("}\n") + 2); // without its FoamFile
}

/// What is said of a key: the lines that have it, each with the comments below it, in one line.
Names passagesOf(const std::string& key, const std::string& text)
{
    const std::regex passage("[^\n]*\\b" + key + "\\b[^\n]*(\n[{}]? +//  [^\n]*|\n[{}]? {12,}//[^\n]*)*");
    Names passages;
    for (std::sregex_iterator match(text.begin(), text.end(), passage), end; match != end; ++match)
    {
        passages.push_back(std::regex_replace(match->str(), std::regex(R"(\s*\n[{}]?\s*//)"), ""));
    }
    return passages;
}

/// "key value; // ... default <value>", "value (default)", "the only one, and the default"; in lists "key (value)".
bool saysDefault(const std::string& passage, const std::string& key, const std::string& value)
{
    const std::string plain = std::regex_replace(value, std::regex(R"([.()+])"), "\\$&") + "(?![\\w.]*\\w)";
    const std::string own = "^[ /]*" + key + "\\b.*", shown = key + " +" + plain;
    for (const std::string& form :
         {own + "[dD]efault:? " + plain, own + "[^\\w.]" + plain + " \\(default",
          "\\b" + shown + "; +// default( \\||$)", "\\b" + shown + ";.* and the default",
          "\\b" + shown + ";.*\\(default " + plain, "\\b" + shown + " \\(default",
          "\\b" + key + " \\(" + plain + "\\)"})
    {
        if (std::regex_search(passage, std::regex(form)))
        {
            return true;
        }
    }
    return false;
}

TEST(AnnotatedDictionaries, HaveEveryKeyThatTheSourcesRead)
{
    const std::vector<Read> reads = allReads();
    EXPECT_GT(reads.size(), 200u);
    for (const Read& read : reads)
    {
        const Names* dictionaries = dictionariesFor(read.source);
        ASSERT_NE(dictionaries, nullptr) << read.source << " reads '" << read.key << "' of no annotated dictionary";
        bool found = dictionaries->empty();
        for (const std::string& dictionary : *dictionaries)
        {
            found = found || !passagesOf(read.key, annotated(dictionary)).empty();
        }
        EXPECT_TRUE(found) << read.key << " of " << read.source << " is not in etc/annotated/"
                           << (found ? "" : dictionaries->front());
    }
}

/// Those that are set are refused by the programs where they do not know them; these may be commented out.
TEST(AnnotatedDictionaries, HaveNoEntryThatNoSourceReads)
{
    std::set<std::string> known = {"writeInterval", "writeControl"}; // read as prefix + "Interval"
    for (const Read& read : allReads())
    {
        known.insert(read.key);
    }
    const std::regex entry(R"((?:\n *(?:// *)?(\w+) {2,}[^ \n;{/][^\n;{/]*|[{;] (\w+) [^\n;{}/]*)(?=;))");
    int entries = 0;
    for (const auto& item : fs::recursive_directory_iterator(fs::path(SLOSH_SOURCE) / "etc/annotated"))
    {
        if (item.is_regular_file())
        {
            const std::string text = annotated(item.path().parent_path().filename() / item.path().filename());
            for (std::sregex_iterator match(text.begin(), text.end(), entry), end; match != end; ++match)
            {
                ++entries;
                const std::string key = (*match)[1].matched ? (*match)[1] : (*match)[2];
                EXPECT_EQ(known.count(key), 1u) << item.path() << (*match)[0];
            }
        }
    }
    EXPECT_GT(entries, 150);
}

TEST(AnnotatedDictionaries, SayTheDefaultsThatTheSourcesHave)
{
    int defaults = 0;
    for (const Read& read : allReads())
    {
        const Names* dictionaries = dictionariesFor(read.source);
        if (read.otherwise.empty() || dictionaries == nullptr || dictionaries->empty())
        {
            continue;
        }
        ++defaults;
        std::string said;
        bool right = false;
        for (const std::string& dictionary : *dictionaries)
        {
            for (const std::string& passage : passagesOf(read.key, annotated(dictionary)))
            {
                said += "\n    " + passage;
                right = right || saysDefault(passage, read.key, read.otherwise);
            }
        }
        EXPECT_TRUE(right) << read.source << ": the default of " << read.key << " is " << read.otherwise
                           << "; etc/annotated says" << said;
    }
    EXPECT_GT(defaults, 50);
}

} // namespace
