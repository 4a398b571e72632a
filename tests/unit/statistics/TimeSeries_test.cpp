// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/TimeSeries.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class Samples : public testing::Test
{
protected:
    Samples() : folder_(fs::temp_directory_path() / ("slosh_samples_" + std::to_string(getpid()))) {}
    ~Samples() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& text) const
    {
        writeFile(folder_ / name, text);
        return folder_ / name;
    }

    fs::path folder_;
};

TEST_F(Samples, VectorsCountThreeColumns)
{
    const auto file = write("f", "# Time  (x y z)\n  0.5\t(1 2 3)\t(4 5 -6e-1)\n  1 (7 8 9) (1 2 3)\n");
    const TimeSeries series = readTimeSeries(file, 6);
    EXPECT_EQ(series.t, (std::vector<double>{0.5, 1}));
    EXPECT_EQ(series.value, (std::vector<double>{-0.6, 3}));
}

TEST_F(Samples, CommaSeparatedTextMayHaveALineOfNamesAndTimesInAnyColumn)
{
    const auto file = write("f.csv", "# source\nphase,eta,t_s\n0.1,5,25\n0.2,6,26\n");
    const TimeSeries series = readTimeSeries(file, 1, 2);
    EXPECT_EQ(series.t, (std::vector<double>{25, 26}));
    EXPECT_EQ(series.value, (std::vector<double>{5, 6}));
}

TEST_F(Samples, BadRowsAreNamedWithTheirLine)
{
    for (const std::string bad : {"2 nan\n", "2 two\n", "2\n"})
    {
        const auto file = write("bad", "# Time\n1 1\n" + bad);
        try
        {
            readTimeSeries(file, 1);
            FAIL() << bad;
        }
        catch (const CaseError& error)
        {
            EXPECT_NE(std::string(error.what()).find(":3: "), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(readTimeSeries(folder_ / "absent", 1), CaseError);
    EXPECT_THROW(readTimeSeries(write("empty", "# Time\n"), 1), CaseError);
}

TEST_F(Samples, OfARestartReplaceThoseItRepeats)
{
    write("pressure/0/p", "0 1\n1 2\n2 3\n");
    write("pressure/1/p", "1.5 20\n2 30\n");
    write("pressure/10/p", "11 4\n");
    const TimeSeries series = readSamples(folder_ / "pressure/p", 1);
    EXPECT_EQ(series.t, (std::vector<double>{0, 1, 1.5, 2, 11}));
    EXPECT_EQ(series.value, (std::vector<double>{1, 2, 20, 30, 4}));
    EXPECT_THROW(readSamples(folder_ / "gauges/height.dat", 1), CaseError);
}

TEST(TimeSeries, IsLinearBetweenItsSamplesAndEndsWithThem)
{
    const TimeSeries series{{0, 1, 3}, {0, 10, -10}};
    EXPECT_DOUBLE_EQ(series.at(0.25), 2.5);
    EXPECT_DOUBLE_EQ(series.at(2), 0);
    EXPECT_DOUBLE_EQ(series.at(3), -10);
    EXPECT_THROW(series.at(3.1), CaseError);
    EXPECT_THROW(series.at(-0.1), CaseError);
    const TimeSeries part = series.between(0.5, 3);
    EXPECT_EQ(part.t, (std::vector<double>{1, 3}));
    EXPECT_TRUE(series.between(1.5, 2).empty());
}

} // namespace
} // namespace slosh
