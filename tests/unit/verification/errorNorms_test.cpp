// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/errorNorms.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slosh
{
namespace
{

TEST(ErrorNorms, AreRelativeToTheExpectedValues)
{
    const ErrorNorms norms = errorNorms({3, 4, 0}, {3, 2, -6});
    EXPECT_DOUBLE_EQ(norms.L2, std::sqrt(40.0 / 49));
    EXPECT_DOUBLE_EQ(norms.Linf, 1);
    EXPECT_EQ(errorNorms({1, -2}, {1, -2}).L2, 0);
    EXPECT_EQ(errorNorms({1, -2}, {1, -2}).Linf, 0);
}

TEST(ErrorNorms, DoNotHideAValueThatIsNoNumber)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(errorNorms({1, nan, 5}, {1, 2, 3}).Linf));
    EXPECT_TRUE(std::isnan(errorNorms({1, nan, 5}, {1, 2, 3}).L2));
}

TEST(ErrorNorms, RefuseWhatHasNoMeaning)
{
    EXPECT_THROW(errorNorms({1}, {1, 2}), CaseError);
    EXPECT_THROW(errorNorms({}, {}), CaseError);
    EXPECT_THROW(errorNorms({1}, {0}), CaseError);
}

TEST(ObservedOrder, OfAPowerIsItsExponentWithoutError)
{
    std::vector<double> dx{0.04, 0.02, 0.01, 0.003}, error;
    for (const double d : dx)
    {
        error.push_back(7 * std::pow(d, 1.7));
    }
    const ObservedOrder order = observedOrder(dx, error);
    EXPECT_NEAR(order.p, 1.7, 1e-13);
    EXPECT_NEAR(order.standardError, 0, 1e-13);
}

// log dx = -1, 0, 1; log error = -2, 0 + 3 r, 2 : slope 2, residuals -r, 2 r, -r, s^2 = 6 r^2/(1 * 2)
TEST(ObservedOrder, HasTheStandardErrorOfTheLine)
{
    const double r = 0.1;
    const ObservedOrder order =
        observedOrder({std::exp(-1), 1, std::exp(1)}, {std::exp(-2), std::exp(3 * r), std::exp(2)});
    EXPECT_NEAR(order.p, 2, 1e-14);
    EXPECT_NEAR(order.standardError, r * std::sqrt(3.0), 1e-14);
}

TEST(ObservedOrder, RefusesWhatHasNoLine)
{
    EXPECT_THROW(observedOrder({1, 2}, {1, 2}), CaseError);
    EXPECT_THROW(observedOrder({1, 2, 3}, {1, 2}), CaseError);
    EXPECT_THROW(observedOrder({1, 2, 3}, {1, 0, 2}), CaseError);
    EXPECT_THROW(observedOrder({1, -2, 3}, {1, 1, 2}), CaseError);
    EXPECT_THROW(observedOrder({2, 2, 2}, {1, 1, 2}), CaseError);
}

} // namespace
} // namespace slosh
