// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/CaseError.hpp"
#include "base/Jet.hpp"
#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "base/threads.hpp"
#include "base/writeFile.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

TEST(NearestName, FindsAMisspeltWordAndLeavesAStrangeOneAlone)
{
    const std::vector<std::string> valid{"cubicSpline", "improvedGaussian", "quinticSpline", "wendlandC2"};
    EXPECT_EQ(nearestName("wendlandc2", valid), "wendlandC2");
    EXPECT_EQ(nearestName("imporvedGaussian", valid), "improvedGaussian"); // two letters changed places
    EXPECT_EQ(nearestName("quinticSplin", valid), "quinticSpline");
    EXPECT_EQ(nearestName("banana", valid), "");
    EXPECT_EQ(nearestName("xyz", {"min", "max"}), "");
    EXPECT_EQ(nearestName("mix", {"min"}), "min");
}

TEST(UnknownName, NamesThePlaceTheNearestNameAndAllValidOnes)
{
    const std::string text = unknownName("plane", "xx", placeIn("constant/tankProperties", 12), {"yz", "xz"}).text();
    EXPECT_NE(text.find("--> FOAM FATAL IO ERROR:"), std::string::npos) << text;
    EXPECT_NE(text.find("constant/tankProperties:12: unknown plane 'xx'"), std::string::npos) << text;
    EXPECT_NE(text.find("Valid planes: xz yz"), std::string::npos) << text;
    const auto plural = [](const std::string& what)
    {
        const std::string all = unknownName(what, "x", "", {"y"}).what();
        return all.substr(all.find("Valid ") + 6, all.rfind(':') - all.find("Valid ") - 6);
    };
    EXPECT_EQ(plural("axis"), "axes");
    EXPECT_EQ(plural("axes"), "axes");
    EXPECT_EQ(plural("quantity"), "quantities");
    EXPECT_EQ(plural("dictionary of a program"), "dictionaries of a program");
    EXPECT_EQ(plural("way to vary"), "ways to vary");
    EXPECT_EQ(plural("type of reference"), "types of reference");
}

TEST(WriteFile, LeavesTheOldFileWholeAndNothingElseWhereItCannotWrite)
{
    const fs::path folder = fs::temp_directory_path() / ("slosh.writeFile." + std::to_string(::getpid()));
    writeFile(folder / "a/b/file", "first");
    writeFile(folder / "a/b/file", "second");
    std::ifstream in(folder / "a/b/file");
    std::string text;
    in >> text;
    EXPECT_EQ(text, "second");
    fs::create_directory(folder / "taken");
    writeFile(folder / "taken/inside", "x");
    EXPECT_THROW(writeFile(folder / "taken", "a folder stands here"), CaseError);
    EXPECT_THROW(writeFile(folder / "a/b/file/below", "a file stands above"), CaseError);
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
    {
        files += entry.is_regular_file() ? 1 : 0;
    }
    EXPECT_EQ(files, 2u) << "a temporary file was left behind";
    fs::remove_all(folder);
}

TEST(ParallelReduce, GivesTheSameBitsAtAnyNumberOfThreads)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> x(123457);
    std::generate(x.begin(), x.end(), [&] { return value(random) * std::pow(10, 8 * value(random)); });
    const auto sum = [&](int threads)
    {
        setThreads(threads);
        return parallelReduce(
            static_cast<std::ptrdiff_t>(x.size()), 0.0,
            [&](std::ptrdiff_t begin, std::ptrdiff_t end)
            { return std::accumulate(x.begin() + begin, x.begin() + end, 0.0); },
            std::plus<>()
        );
    };
    const int usual = threads();
    const double one = sum(1), two = sum(2), five = sum(5);
    setThreads(usual);
    EXPECT_EQ(one, two);
    EXPECT_EQ(one, five);
    EXPECT_NEAR(one, std::accumulate(x.begin(), x.end(), 0.0), 1e-4);
}

TEST(ParallelBlocks, VisitEveryIndexOnce)
{
    std::vector<int> visits(1000, 0);
    parallelBlocks(
        1000, 7,
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                ++visits[i];
            }
        }
    );
    EXPECT_EQ(visits, std::vector<int>(1000, 1));
}

/// f at several numbers of threads.
template <class F>
void atThreads(const F& f)
{
    const int usual = threads();
    for (const int n : {1, 2, 3, 8})
    {
        setThreads(n);
        f(n);
    }
    setThreads(usual);
}

TEST(OnThreads, TakesEachShareOnceAndWorksAloneWhereItIsInside)
{
    atThreads(
        [](int n)
        {
            for (int call = 0; call < 200; ++call)
            {
                std::vector<int> taken(n, 0), sharesInside(n, 0);
                onThreads(
                    [&](int share, int shares)
                    {
                        taken[share] += shares;
                        onThreads([&](int, int inside) { sharesInside[share] += inside; });
                    }
                );
                ASSERT_EQ(taken, std::vector<int>(n, n));
                ASSERT_EQ(sharesInside, std::vector<int>(n, 1));
            }
        }
    );
}

TEST(Countdowns, SayOfEachWhenAllItWaitsForIsDoneAndWhatWasWrittenCanBeRead)
{
    constexpr std::ptrdiff_t tasks = 100;
    Countdowns waiting;
    waiting.start(std::vector<int>(tasks, 2)); // for itself and the one after it
    atThreads(
        [&](int)
        {
            for (int call = 0; call < 100; ++call)
            {
                std::vector<std::ptrdiff_t> written(tasks, 0), read(tasks, 0);
                parallelTasks(
                    tasks,
                    [&](std::ptrdiff_t k)
                    {
                        written[k] = k + 1;
                        for (const std::ptrdiff_t waits : {k, (k + tasks - 1) % tasks})
                        {
                            if (waiting.isLast(waits))
                            {
                                read[waits] += written[waits] * 1000 + written[(waits + 1) % tasks];
                            }
                        }
                    }
                );
                for (std::ptrdiff_t k = 0; k < tasks; ++k)
                {
                    ASSERT_EQ(read[k], (k + 1) * 1000 + (k + 1) % tasks + 1);
                }
            }
        }
    );
}

template <class S>
void expectSelection()
{
    const S x([](auto lane) { return static_cast<RealOf<S>>(lane); });
    EXPECT_EQ(whereLess(x, S(2)), 3);
    const S chosen = select(x < 2, x, -x);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanesOf<S>); ++lane)
    {
        EXPECT_EQ(chosen[lane], lane < 2 ? x[lane] : -x[lane]) << lane;
    }
}

TEST(Select, TakesEachLaneFromWhereItsConditionSays)
{
    expectSelection<Simd<float>>();
    expectSelection<Simd<double>>();
}

template <class S>
double largestErrorOfExp()
{
    double largest = 0;
    for (int k = 0; k <= 20000; ++k)
    {
        const auto x = static_cast<RealOf<S>>(9.0 * k / 20000);
        const S value = expOfMinus(S(x));
        const double exact = std::exp(-static_cast<double>(x));
        largest = std::max(largest, std::abs(static_cast<double>(value[0]) / exact - 1));
    }
    return largest;
}

TEST(ExpOfMinus, IsAsAccurateAsStated)
{
    EXPECT_LT(largestErrorOfExp<Simd<float>>(), 2.5e-6);
    EXPECT_LT(largestErrorOfExp<Simd<double>>(), 1e-13);
    EXPECT_FALSE(std::isnan(static_cast<float>(expOfMinus(Simd<float>(1e12F))[0])));
}

template <class S>
void expectFusedAndSummed()
{
    using T = RealOf<S>;
    constexpr int lanes = lanesOf<S>;
    // (1 + e)^2 - 1 - 2e = e^2, which rounding of the product would lose.
    const T e = std::numeric_limits<T>::epsilon();
    const S fused = multiplyAdd(S(1 + e), S(1 + e), S(-1 - 2 * e));
#ifdef __FMA__
    EXPECT_EQ(fused[lanes - 1], e * e);
    EXPECT_EQ(multiplyAdd(T(1 + e), T(1 + e), T(-1 - 2 * e)), e * e);
#endif
    EXPECT_EQ(subtractProduct(S(3), S(4), S(5))[0], -7);
    std::array<S, lanes> rows;
    for (int k = 0; k < lanes; ++k)
    {
        rows[k] = S([&](auto lane) { return T(100 * k + static_cast<int>(lane) * static_cast<int>(lane)); });
    }
    const S sums = rowSums(rows.data());
    for (int k = 0; k < lanes; ++k)
    {
        EXPECT_EQ(sums[k], T(100 * k * lanes + (lanes - 1) * lanes * (2 * lanes - 1) / 6)) << k;
    }
}

TEST(Simd, FusesWhereItIsToldToAndSumsRows)
{
    expectFusedAndSummed<Simd<float>>();
    expectFusedAndSummed<Simd<double>>();
    EXPECT_EQ(lanesOf<Simd<float>>, 8);
    EXPECT_EQ(lanesOf<Simd<double>>, 4);
}

TEST(Jet, DifferentiatesEveryOperation)
{
    const auto f = [](const Jet& t) { return sin(t * t) * exp(-t) / (Jet(2) + cos(t)) - log(Jet(1) + t * t); };
    constexpr double t = 0.7, h = 1e-4;
    const Jet here = f(Jet::time(t));
    const double before = f(Jet(t - h)).f, after = f(Jet(t + h)).f;
    EXPECT_NEAR(here.d, (after - before) / (2 * h), 1e-7);
    EXPECT_NEAR(here.dd, (after - 2 * here.f + before) / (h * h), 1e-6);
}

} // namespace
} // namespace slosh
