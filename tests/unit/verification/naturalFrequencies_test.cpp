// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/naturalFrequencies.hpp"

#include "base/CaseError.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <vector>

namespace slosh
{
namespace
{

TEST(NaturalFrequencies, OfRectangularTanksAreThoseOfThePapers)
{
    // L, h and the first three, to five decimals
    EXPECT_NEAR(rectangularFrequency(1, 0.92, 0.155, 9.81), 4.03008, 5e-6); // Cao et al. 2014 print 4.025
    EXPECT_NEAR(rectangularFrequency(2, 0.92, 0.155, 9.81), 7.25268, 5e-6);
    EXPECT_NEAR(rectangularFrequency(3, 0.92, 0.155, 9.81), 9.61453, 5e-6);
    EXPECT_NEAR(rectangularFrequency(1, 0.6, 0.3, 9.81), 6.8636, 5e-5);                // Cao et al., section 3.2
    EXPECT_NEAR(1.1 * rectangularFrequency(1, 0.59, 0.508 * 0.59, 9.81), 7.630, 5e-4); // section 3.3
}

TEST(NaturalFrequencies, OfABoxAreThoseOfItsSidesAndDegenerateInASquare)
{
    EXPECT_DOUBLE_EQ(boxFrequency(3, 0, 0.9, 0.4, 0.3, 9.81), rectangularFrequency(3, 0.9, 0.3, 9.81));
    EXPECT_DOUBLE_EQ(boxFrequency(0, 2, 0.9, 0.4, 0.3, 9.81), rectangularFrequency(2, 0.4, 0.3, 9.81));
    EXPECT_DOUBLE_EQ(boxFrequency(1, 2, 0.5, 0.5, 0.3, 9.81), boxFrequency(2, 1, 0.5, 0.5, 0.3, 9.81));
    // shallow: omega = kappa sqrt(g h)
    const double kappa = std::numbers::pi * std::sqrt(1 + 4.0);
    EXPECT_NEAR(boxFrequency(1, 2, 1, 1, 1e-4, 9.81), kappa * std::sqrt(9.81e-4), 1e-7);
}

TEST(NaturalFrequencies, OfAnUprightCylinderBelongToWavesThatMeetItsWallUpright)
{
    const double g = 9.81, R = 0.4;
    for (const int m : {0, 1, 2})
    {
        const double omega = uprightCylinderFrequency(m, R, 100, g); // deep: k = omega^2/g
        const double xi = omega * omega / g * R, d = 1e-5;
        const double slope = (std::cyl_bessel_j(m, xi + d) - std::cyl_bessel_j(m, xi - d)) / (2 * d);
        EXPECT_NEAR(slope, 0, 1e-9);
    }
    EXPECT_NEAR(uprightCylinderFrequency(1, R, 0.2, g), waveFrequency(1.84118 / R, 0.2, g), 2e-5);
    EXPECT_THROW(uprightCylinderFrequency(3, R, 0.2, g), CaseError);
}

using Wide = long double; // powers are nearly dependent

/// B(i/2, j/2) to the last digit, by its recurrence.
Wide beta(int i, int j)
{
    if (i > 2)
    {
        return beta(i - 2, j) * (i - 2) / (i - 2 + j);
    }
    return j > 2 ? beta(j, i) : i * j == 1 ? std::numbers::pi_v<Wide> : i * j == 4 ? 1 : 2;
}

/// Integral of r^p z^q over the quarter disc r >= 0, z <= 0, r^2 + z^2 <= 1 (z replaced by |z|).
Wide quarterDisc(int p, int q)
{
    return beta(p + 1, q + 1) / 2 / (p + q + 2);
}

/// omega^2 R/g of a half-full round tank by Rayleigh's and Ritz's method: stationary values of
/// integral |grad phi|^2 / integral over the surface of phi^2, phi = sum r^p z^q, p = first, first + 2 ...; `m` waves
/// around a vertical axis and dA = r^weight dr dz: 0 in the plane, 1 for a sphere. z is positive downwards.
std::vector<Wide> rayleighRitz(int first, int m, int weight, int degree)
{
    struct Power
    {
        int p, q;
    };
    std::vector<Power> powers;
    for (int p = first; p <= degree; p += 2)
    {
        for (int q = 0; p + q <= degree; ++q)
        {
            if (p + q > 0)
            {
                powers.push_back({p, q});
            }
        }
    }
    const auto surface = [weight](int p, int q) { return q == 0 ? Wide(1) / (p + weight + 1) : 0; };
    const auto n = static_cast<Eigen::Index>(powers.size());
    using Matrix = Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic>;
    Matrix stiffness(n, n), mass(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        for (Eigen::Index j = 0; j < n; ++j)
        {
            const auto [p1, q1] = powers[i];
            const auto [p2, q2] = powers[j];
            const int p = p1 + p2, q = q1 + q2;
            const Wide across = p1 * p2 + m * m, down = q1 * q2;
            stiffness(i, j) = (across > 0 ? across * quarterDisc(p - 2 + weight, q) : 0) +
                              (down > 0 ? down * quarterDisc(p + weight, q - 2) : 0);
            // the surface's mean is taken out: no flow through it
            const Wide mean = first == 0 ? surface(p1, q1) * surface(p2, q2) / surface(0, 0) : 0;
            mass(i, j) = surface(p, q) - mean;
        }
    }
    // largest 1/lambda first: mass is singular, stiffness is not
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(mass, stiffness);
    return {1 / solver.eigenvalues()[n - 1], 1 / solver.eigenvalues()[n - 2]};
}

TEST(NaturalFrequencies, OfHalfFullRoundTanksAgreeWithRayleighRitz)
{
    const auto agree = [](const std::vector<Wide>& upper, double lambda1, double lambda2)
    {
        EXPECT_NEAR(upper[0], lambda1, 2e-6);
        EXPECT_NEAR(upper[1], lambda2, 4e-5);
        EXPECT_GT(upper[0], lambda1 - 1e-6); // the method gives upper bounds
        EXPECT_GT(upper[1], lambda2 - 1e-6);
    };
    const int degree = 13; // from 15 on rounding wins
    agree(rayleighRitz(1, 0, 0, degree), halfFullCylinderAntisymmetric[0], halfFullCylinderAntisymmetric[1]);
    agree(rayleighRitz(0, 0, 0, degree), halfFullCylinderSymmetric[0], halfFullCylinderSymmetric[1]);
    agree(rayleighRitz(1, 1, 1, degree), halfFullSphereFirst[0], halfFullSphereFirst[1]);
    EXPECT_NEAR(rayleighRitz(0, 0, 1, degree)[0], halfFullSphereAxisymmetric, 2e-6);
    EXPECT_DOUBLE_EQ(roundTankFrequency(2, 0.5, 9), 6);
}

} // namespace
} // namespace slosh
