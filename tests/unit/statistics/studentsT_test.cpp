// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/studentsT.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

// nu = 1: A = 2/pi atan t; nu = 2: A = t/sqrt(2 + t^2).
TEST(StudentsT, IsThatOfItsClosedForms)
{
    for (const double t : {0.0, 0.3, 1.0, 12.7})
    {
        EXPECT_NEAR(studentsProbability(t, 1), 2 / std::numbers::pi * std::atan(t), 1e-15);
        EXPECT_NEAR(studentsProbability(t, 2), t / std::sqrt(2 + t * t), 1e-15);
    }
    EXPECT_NEAR(studentsT(0.5, 1), 1, 1e-14);
    EXPECT_NEAR(studentsT(0.95, 2), 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95)), 1e-12);
}

/// The integral of the density, G((nu + 1)/2)/(sqrt(nu pi) G(nu/2)) (1 + t^2/nu)^(-(nu + 1)/2), by Simpson's rule.
double integralOfDensity(double t, double nu)
{
    const double factor = std::exp(std::lgamma((nu + 1) / 2) - std::lgamma(nu / 2)) / std::sqrt(nu * std::numbers::pi);
    const auto density = [&](double x) { return factor * std::pow(1 + x * x / nu, -(nu + 1) / 2); };
    constexpr int n = 2000;
    double sum = density(0) + density(t);
    for (int i = 1; i < n; ++i)
    {
        sum += (i % 2 == 1 ? 4 : 2) * density(t * i / n);
    }
    return 2 * sum * t / n / 3;
}

TEST(StudentsT, IsTheIntegralOfTheDensity)
{
    for (const std::size_t nu : {3, 4, 5, 8, 19, 60, 401})
    {
        for (const double t : {0.1, 1.0, 2.5, 6.0})
        {
            EXPECT_NEAR(studentsProbability(t, nu), integralOfDensity(t, static_cast<double>(nu)), 1e-12) << nu;
        }
        EXPECT_NEAR(studentsProbability(studentsT(0.95, nu), nu), 0.95, 1e-13) << nu;
    }
    EXPECT_NEAR(studentsT(0.95, 100001), 1.95996, 1e-4) << "the normal distribution's";
}

TEST(StudentsT, RefusesWhatHasNoProbability)
{
    EXPECT_THROW(studentsT(0.95, 0), CaseError);
    EXPECT_THROW(studentsT(1, 5), CaseError);
    EXPECT_THROW(studentsT(0, 5), CaseError);
    EXPECT_THROW(studentsT(std::nan(""), 5), CaseError);
    EXPECT_THROW(studentsProbability(-1, 5), CaseError);
    EXPECT_THROW(studentsProbability(1, 0), CaseError);
}

} // namespace
} // namespace slosh
