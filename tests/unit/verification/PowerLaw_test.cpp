// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/PowerLaw.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh
{
namespace
{

TEST(PowerLaw, ThroughExactPowersIsFoundExactly)
{
    for (const double p : {-3.0, -0.5, 1.7, 4.0})
    {
        std::vector<double> x{0.03, 0.01, 0.2, 0.005}, y;
        for (const double each : x)
        {
            y.push_back(7e-3 * std::pow(each, p));
        }
        const PowerLaw law = fitPowerLaw(x, y);
        EXPECT_NEAR(law.p, p, 1e-12);
        EXPECT_NEAR(law.C / 7e-3, 1, 1e-11);
        EXPECT_NEAR(law.standardError, 0, 1e-12);
        EXPECT_NEAR(law(0.07) / (7e-3 * std::pow(0.07, p)), 1, 1e-11);
        EXPECT_NEAR(law.inverse(law(0.07)), 0.07, 1e-12);
    }
}

TEST(PowerLaw, ThroughTwoPointsHasNoKnownScatter)
{
    const PowerLaw law = fitPowerLaw({1, 2}, {3, 12});
    EXPECT_NEAR(law.p, 2, 1e-14);
    EXPECT_NEAR(law.C, 3, 1e-14);
    EXPECT_TRUE(std::isnan(law.standardError));
}

// log x = -1, 0, 1; log y = -2, 3 r, 2: slope 2 through the mean (0, r); residuals -r, 2 r, -r.
TEST(PowerLaw, PassesThroughTheMeanOfItsLogarithms)
{
    const double r = 0.1;
    const PowerLaw law = fitPowerLaw({std::exp(-1), 1, std::exp(1)}, {std::exp(-2), std::exp(3 * r), std::exp(2)});
    EXPECT_NEAR(law.p, 2, 1e-14);
    EXPECT_NEAR(law.C, std::exp(r), 1e-14);
    EXPECT_NEAR(law.standardError, r * std::sqrt(3.0), 1e-14);
}

TEST(PowerLaw, ThatDoesNotDependOnItsVariableReachesNothing)
{
    const PowerLaw law = fitPowerLaw({1, 2, 4}, {5, 5, 5});
    EXPECT_EQ(law.p, 0);
    EXPECT_TRUE(std::isnan(law.inverse(3)));
}

TEST(PowerLaw, RefusesWhatHasNoLine)
{
    EXPECT_THROW(fitPowerLaw({1}, {1}), CaseError);
    EXPECT_THROW(fitPowerLaw({1, 2}, {1, 2, 3}), CaseError);
    EXPECT_THROW(fitPowerLaw({1, 0}, {1, 2}), CaseError);
    EXPECT_THROW(fitPowerLaw({1, 2}, {1, std::nan("")}), CaseError);
    EXPECT_THROW(fitPowerLaw({2, 2}, {1, 2}), CaseError);
}

} // namespace
} // namespace slosh
