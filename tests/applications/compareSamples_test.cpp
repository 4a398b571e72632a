// compareSamples as a user runs it, on samples whose figures are known.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace slosh
{
namespace
{

/// The columns of the table's row that begins with `description`.
std::vector<std::string> row(const CaseDirectory& theCase, const std::string& description)
{
    std::istringstream table(theCase.text("postProcessing/compareSamples/comparisons.tsv"));
    for (std::string line; std::getline(table, line);)
    {
        std::vector<std::string> columns;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t');)
        {
            columns.push_back(cell);
        }
        if (!columns.empty() && columns[0] == description)
        {
            return columns;
        }
    }
    return std::vector<std::string>(4, "no row " + description);
}

TEST(CompareSamples, HoldsThePeakOfTheMovingAverageAgainstTheStatedOne)
{
    const CaseDirectory theCase;
    // A triangle of 1000 Pa, 0.2 s wide: its mean over 0.1 s about the top is 750 Pa.
    std::ostringstream samples;
    for (int k = 0; k <= 100; ++k)
    {
        samples << 0.01 * k << " " << 1000 * std::max(0.0, 1 - std::abs(k - 50) / 10.0) << "\n";
    }
    theCase.write("postProcessing/pressure/0/p", samples.str());
    const std::string peak = "samples pressure/p; column 1; unit Pa; quantity maximum;"
                             " reference { type stated; value 500; source \"a paper\"; } ";
    theCase.write("system/comparisonsDict", "raw { " + peak + "} filtered { " + peak + " filter 0.1; }");
    theCase.succeed("compareSamples");
    EXPECT_EQ(row(theCase, "raw")[1], "1000 Pa");
    EXPECT_EQ(row(theCase, "raw")[3], "100 %");
    EXPECT_EQ(row(theCase, "filtered")[1], "750 Pa");
    EXPECT_EQ(row(theCase, "filtered")[3], "50 %");
    EXPECT_EQ(row(theCase, "filtered")[4], "a paper");
}

TEST(CompareSamples, StatesHowLateAnInstantIsNotWhichShareOfTheClock)
{
    const CaseDirectory theCase;
    theCase.write("postProcessing/pressure/0/p", "9 0\n10 0\n10.5 200\n11 0\n");
    theCase.write("system/comparisonsDict", "rise { samples pressure/p; column 1; unit s; quantity firstTimeAbove;"
                                            " level 100; reference { type stated; value 10; } }");
    theCase.succeed("compareSamples");
    EXPECT_EQ(row(theCase, "rise")[1], "10.25 s");
    EXPECT_EQ(row(theCase, "rise")[3], "0.25 s");
}

} // namespace
} // namespace slosh
