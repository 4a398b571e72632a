// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Case.hpp"
#include "case/Controls.hpp"
#include "case/Schedule.hpp"
#include "case/foamFile.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

class CaseFolder : public testing::Test
{
protected:
    void SetUp() override
    {
        root = fs::temp_directory_path() / ("slosh.case." + std::to_string(::getpid()));
        fs::create_directories(root / "constant");
        fs::create_directories(root / "system");
    }
    void TearDown() override { fs::remove_all(root); }

    /// Controls of a case with the times 0, 0.5 and 10.
    Controls controls(const std::string& text) const
    {
        for (const char* time : {"0", "0.5", "10"})
        {
            fs::create_directories(root / time / "lagrangian");
        }
        writeFile(root / "system/controlDict", text);
        return Controls(Case(root));
    }
    fs::path root;
};

TEST(Schedule, IsDueOnceInEveryIntervalWhateverTheSteps)
{
    const Schedule schedule(Schedule::Control::runTime, 0.1);
    int due = 0;
    double time = 0;
    for (long index = 1; index <= 1000; ++index)
    {
        const double next = time + 0.0031 * (1 + 0.3 * std::sin(static_cast<double>(index)));
        due += schedule.isDue({.time = time}, {.time = next, .index = index}) ? 1 : 0;
        time = next;
    }
    EXPECT_EQ(due, static_cast<int>(std::floor(time / 0.1)));
}

TEST(Schedule, EndsAStepOnTheInstantAndCountsItOnce)
{
    const Schedule schedule(Schedule::Control::adjustableRunTime, 0.1);
    EXPECT_NEAR(schedule.nextInstant(0.25), 0.3, 1e-15);
    double time = 0;
    for (int k = 1; k <= 1000; ++k) // rounding must neither skip an instant nor count one twice
    {
        const double next = schedule.nextInstant(time);
        EXPECT_NEAR(next, 0.1 * k, 1e-9);
        EXPECT_TRUE(schedule.isDue({.time = time}, {.time = next}));
        time = next;
    }
    EXPECT_EQ(Schedule(Schedule::Control::runTime, 0.1).nextInstant(1), std::numeric_limits<double>::infinity());
}

TEST(Schedule, CountsSteps)
{
    const Schedule schedule(Schedule::Control::timeStep, 5);
    EXPECT_TRUE(schedule.isDue({}, {.index = 10}));
    EXPECT_FALSE(schedule.isDue({}, {.index = 11}));
}

TEST(Schedule, CountsRealAndProcessorTimeApart)
{
    const Schedule clock(Schedule::Control::clockTime, 60), processor(Schedule::Control::cpuTime, 60);
    const Instant before{.clock = 50, .processor = 100}, now{.clock = 70, .processor = 110};
    EXPECT_TRUE(clock.isDue(before, now));
    EXPECT_FALSE(processor.isDue(before, now));
    EXPECT_TRUE(processor.isDue(before, {.clock = 59, .processor = 121}));
    EXPECT_FALSE(clock.isDue(before, {.clock = 59, .processor = 121}));
}

TEST(Schedule, FollowsTheTimesWrittenAndTheEnd)
{
    const Schedule second(Schedule::Control::writeTime, 2), end(Schedule::Control::onEnd, 1);
    EXPECT_FALSE(second.isDue({.writes = 0}, {.writes = 1}));
    EXPECT_TRUE(second.isDue({.writes = 1}, {.writes = 2}));
    EXPECT_FALSE(second.isDue({.writes = 2}, {.writes = 2}));
    EXPECT_FALSE(end.isDue({}, {.ends = false}));
    EXPECT_TRUE(end.isDue({}, {.ends = true}));
}

const std::string basic = "startTime 0.5; stopAt endTime; endTime 2; deltaT 0.0037; writeInterval 0.5; ";

TEST_F(CaseFolder, StartsWhereStartFromSays)
{
    EXPECT_EQ(controls(basic + "startFrom firstTime; writeControl runTime;").startName(), "0");
    EXPECT_EQ(controls(basic + "startFrom startTime; writeControl runTime;").startName(), "0.5");
    EXPECT_THROW(controls(basic + "startFrom latestTime; writeControl runTime;"), CaseError) << "10 is after endTime";
    EXPECT_THROW(controls("startFrom startTime; startTime 0.7; endTime 2; deltaT 0.1; writeInterval 1;"), CaseError);
    EXPECT_THROW(controls(basic + "startFrom absent;"), CaseError);
}

/// The entries of the interFoam tutorials' controlDict, all of them, but that files are compressed.
TEST_F(CaseFolder, TakesWhatTheControlDictOfInterFoamHolds)
{
    const std::string shared = "application interFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 40; "
                               "deltaT 0.01; writeControl adjustable; writeInterval 0.05; purgeWrite 0; writeFormat "
                               "ascii; writePrecision 6; timeFormat general; timePrecision 6; runTimeModifiable yes; "
                               "adjustTimeStep yes; maxCo 0.5; maxAlphaCo 0.5; maxDeltaT 1; libs (sampling);";
    EXPECT_EQ(controls(shared + "writeCompression off;").startName(), "0");
    EXPECT_THROW(controls(shared + "writeCompression on;"), CaseError) << "it would not be";
    EXPECT_THROW(controls(shared + "maxAlfaCo 0.5;"), CaseError);
}

TEST_F(CaseFolder, EndsStepsOnWriteInstantsAndOnTheEnd)
{
    Controls clock = controls(basic + "startFrom firstTime; writeControl adjustableRunTime;");
    clock.resume(0, 0, 0.0037);
    int writes = 0;
    long steps = 0;
    double shortest = 1;
    while (clock.running())
    {
        const double dt = clock.limitDeltaT(0.0037, std::numeric_limits<double>::infinity());
        EXPECT_LE(dt, 0.0037 * (1 + 1e-12));
        shortest = std::min(shortest, dt);
        clock.advance(dt);
        writes += clock.isWriteTime() ? 1 : 0;
        ASSERT_LT(++steps, 1000);
    }
    EXPECT_EQ(clock.time(), 2.0);
    EXPECT_EQ(writes, 4);
    EXPECT_GT(shortest, 0.0037 / 2.01) << "a sliver of a step";
}

TEST_F(CaseFolder, SortsTimesByValueAndLeavesOtherFoldersAlone)
{
    for (const char* name : {"10", "9.5", "1e-05", "0", "constant", "0.org"})
    {
        fs::create_directories(root / name / "lagrangian");
    }
    fs::create_directories(root / "7");
    std::vector<std::string> names;
    for (const TimeDirectory& time : Case(root).times())
    {
        names.push_back(time.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"0", "1e-05", "9.5", "10"}));
    EXPECT_THROW(Case(root / "none"), CaseError);
}

TEST_F(CaseFolder, FieldsComeBackInBothFormats)
{
    const std::vector<double> rho{1000, 1.0 / 3, -2e-300};
    const std::vector<Vec> U{Vec(1, 2, 3), Vec(1.0 / 7, 0, -1e10), Vec(0, 0, 0)};
    const std::vector<int> ids{3, -1, 2147483647};
    for (const WriteFormat format : {WriteFormat::ascii, WriteFormat::binary})
    {
        const WriteOptions options{format, 17};
        const std::string folder = "0.5/lagrangian/fluid";
        writeField(root, folder, "rho", std::span<const double>(rho), options);
        writeField(root, folder, "U", std::span<const Vec>(U), options);
        writeField(root, folder, "origId", std::span<const int>(ids), options);
        writePositions(root, folder, std::span<const Vec>(U), options);
        EXPECT_EQ(readScalarField(root, folder + "/rho", 3), rho);
        EXPECT_EQ(readVectorField(root, folder + "/U"), U);
        EXPECT_EQ(readLabelField(root, folder + "/origId"), ids);
        EXPECT_EQ(readPositions(root, folder + "/positions"), U);
        EXPECT_THROW(readScalarField(root, folder + "/rho", 4), CaseError);
        EXPECT_THROW(readVectorField(root, folder + "/rho"), CaseError) << "of another class";
        EXPECT_THROW(readScalarField(root, folder + "/none"), CaseError);
    }
}

TEST_F(CaseFolder, ReadsUniformFieldsAndSinglePrecisionOfOthers)
{
    writeFile(root / "uniform", "FoamFile { version 2.0; format ascii; class scalarField; object p; }\n3{7.5}\n");
    EXPECT_EQ(readScalarField(root, "uniform"), (std::vector<double>{7.5, 7.5, 7.5}));
    const float raw[2] = {1.5F, -2.25F};
    writeFile(
        root / "single", "FoamFile { version 2.0; format binary; arch \"LSB;label=32;scalar=32\"; class scalarField; "
                         "object p; }\n2(" +
                             std::string(reinterpret_cast<const char*>(raw), sizeof raw) + ")\n"
    );
    EXPECT_EQ(readScalarField(root, "single"), (std::vector<double>{1.5, -2.25}));
}

TEST(Schedule, OfAFunctionIsByOnePairOfEntries)
{
    const auto read = [](const std::string& text)
    { return Schedule::readOfFunction(Dictionary::parse(text, "probes")); };
    const Instant before{.time = 0, .index = 4}, now{.time = 0.2, .index = 5};
    EXPECT_TRUE(read("writeInterval 5;").isDue(before, now));
    EXPECT_FALSE(read("writeInterval 4;").isDue(before, now));
    EXPECT_TRUE(read("executeControl runTime; executeInterval 0.1;").isDue(before, now));
    EXPECT_TRUE(read("executeControl runTime; executeInterval 1; writeControl timeStep;").isDue(before, now));
    EXPECT_THROW(read("executeControl runTime; executeInterval 0.1; writeInterval 5;"), CaseError);
    EXPECT_THROW(read("executeInterval 2; writeInterval 5;"), CaseError);
    // An interval that its control does not need is no error.
    for (const std::string control : {"none", "onEnd", "always"})
    {
        const Dictionary dict = Dictionary::parse("writeControl " + control + "; writeInterval 5;", "probes");
        Schedule::readOfFunction(dict);
        EXPECT_NO_THROW(dict.refuseIdle(functionScheduleKeys())) << control;
    }
}

} // namespace
} // namespace slosh
