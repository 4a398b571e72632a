// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/HarmonicExpansion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

constexpr double pi = std::numbers::pi;

TEST(CosineModes, GoToTheGridAndBackAndHaveTheirSlopes)
{
    const CosineModes modes(0.7, 24);
    const Eigen::ArrayXXd a = Eigen::ArrayXXd::Random(24, 3);
    EXPECT_LT((modes.amplitudes(modes.values(a), 24) - a).abs().maxCoeff(), 1e-14);
    EXPECT_LT((modes.amplitudes(modes.values(a), 5) - a.topRows(5)).abs().maxCoeff(), 1e-14);
    Eigen::ArrayXd third = Eigen::ArrayXd::Zero(4);
    third(3) = 2;
    const Eigen::ArrayXd phase = 3 * pi / 0.7 * modes.points();
    EXPECT_LT((modes.values(third).col(0) - 2 * phase.cos()).abs().maxCoeff(), 1e-14);
    EXPECT_LT((modes.slopes(third).col(0) + 6 * pi / 0.7 * phase.sin()).abs().maxCoeff(), 1e-12);
}

/// phi = cosh k(y + h)/cosh k h cos k s below the surface eta = a cos q s + b cos 2 q s, whose W is known.
class Below
{
public:
    Below(double amplitude, int M, Eigen::Index P = 48) : expansion_(CosineModes(L, P), h, M)
    {
        const Eigen::ArrayXd s = expansion_.modes().points();
        eta_ = amplitude * ((pi / L * s).cos() + 0.5 * (2 * pi / L * s).cos());
        f_ = (k * (eta_ + h)).cosh() / std::cosh(k * h) * (k * s).cos();
        exact_ = k * (k * (eta_ + h)).sinh() / std::cosh(k * h) * (k * s).cos();
        terms_ = expansion_(eta_, f_);
    }

    double errorOfW() const { return (terms_.W.rowwise().sum() - exact_).abs().maxCoeff(); }
    double errorOfPhi() const
    {
        Eigen::ArrayXd exact = Eigen::ArrayXd::Zero(terms_.phi.size());
        exact(2) = 1;
        return (terms_.phi - exact).abs().maxCoeff();
    }

    static constexpr double L = 1.3, h = 0.4, k = 2 * pi / L;

private:
    HarmonicExpansion expansion_;
    Eigen::ArrayXd eta_, f_, exact_;
    HarmonicExpansion::Terms terms_;
};

TEST(HarmonicExpansion, OfALevelSurfaceIsTheFirstTerm)
{
    EXPECT_LT(Below(0, 1).errorOfW(), 1e-11);
    EXPECT_LT(Below(0, 4).errorOfW(), 1e-11);
}

TEST(HarmonicExpansion, HasAnErrorOfItsOrderInTheElevation)
{
    for (int M = 1; M <= 6; ++M)
    {
        const double order = std::log2(Below(0.03, M).errorOfW() / Below(0.015, M).errorOfW());
        EXPECT_NEAR(order, M, 0.25) << M;
        const double orderOfPhi = std::log2(Below(0.03, M).errorOfPhi() / Below(0.015, M).errorOfPhi());
        EXPECT_NEAR(orderOfPhi, M, 0.25) << M;
    }
}

TEST(HarmonicExpansion, IsExactInItsFirstModesOnTheFewestPointsThatItNames)
{
    const int M = 6;
    const Eigen::Index N = 10, P = (M + 1) * N / 2 + 1;
    const HarmonicExpansion few(CosineModes(1, P), 0.3, M), many(CosineModes(1, 4 * P), 0.3, M);
    Eigen::ArrayXXd a = 0.01 * Eigen::ArrayXXd::Random(N + 1, 2); // eta and f
    const auto firstModes = [&](const HarmonicExpansion& of)
    {
        const Eigen::ArrayXXd onGrid = of.modes().values(a);
        const auto terms = of(onGrid.col(0), onGrid.col(1));
        return Eigen::ArrayXXd(of.modes().amplitudes(terms.W, N + 1));
    };
    const Eigen::ArrayXXd W = firstModes(many);
    EXPECT_LT((firstModes(few) - W).abs().maxCoeff(), 1e-12 * W.abs().maxCoeff());
    const HarmonicExpansion fewer(CosineModes(1, P - N), 0.3, M);
    EXPECT_GT((firstModes(fewer) - W).abs().maxCoeff(), 1e-6 * W.abs().maxCoeff());
}

} // namespace
} // namespace slosh
