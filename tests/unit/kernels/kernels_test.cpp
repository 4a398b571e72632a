// SPDX-License-Identifier: GPL-3.0-or-later
// Every kernel: the properties that make it one.
#include "base/simd.hpp"
#include "forEveryKernel.hpp"
#include "kernels/Kernel.hpp"

#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh
{
namespace
{

std::vector<KernelChoice> allKernels()
{
    return {CubicSpline{}, ImprovedGaussian{}, QuinticSpline{}, TaperedGaussian{}, WendlandC2{}};
}

/// Simpson's rule over [0, support] in 20000 pieces.
template <class F>
double integral(double end, const F& f)
{
    constexpr int n = 20000;
    double sum = f(0.0) + f(end);
    for (int k = 1; k < n; ++k)
    {
        sum += f(end * k / n) * (k % 2 == 1 ? 4 : 2);
    }
    return sum * end / (3 * n);
}

TEST(Kernels, IntegrateToOneOverTheirSupportIn2DAnd3D)
{
    constexpr double h = 0.7;
    for (const auto& choice : allKernels())
    {
        const Kernel in2D(choice, 2, h), in3D(choice, 3, h);
        const double pi = std::numbers::pi;
        EXPECT_NEAR(integral(in2D.supportRadius(), [&](double r) { return 2 * pi * r * in2D.W(r); }), 1, 1e-8)
            << in2D.name();
        EXPECT_NEAR(integral(in3D.supportRadius(), [&](double r) { return 4 * pi * r * r * in3D.W(r); }), 1, 1e-8)
            << in3D.name();
    }
}

/// int W(r) e^(i G . x) dA in 2D for a lattice's wave number G = 2 pi/dx: what sums over its particles feel of it.
double shareOfTheLattice(const KernelChoice& choice, double hOverDx)
{
    const Kernel kernel(choice, 2, hOverDx);
    return integral(
        kernel.supportRadius(), [&](double r)
        { return 2 * std::numbers::pi * r * kernel.W(r) * std::cyl_bessel_j(0, 2 * std::numbers::pi * r); }
    );
}

TEST(TaperedGaussian, FeelsTheLatticeOfTheParticlesTenTimesLessThanTheImprovedGaussianThatIsNearlyAsWide)
{
    const auto width = [](const KernelChoice& choice, double h) // the root of the mean of r^2
    {
        const Kernel kernel(choice, 2, h);
        return std::sqrt(
            integral(kernel.supportRadius(), [&](double r) { return 2 * std::numbers::pi * r * r * r * kernel.W(r); })
        );
    };
    EXPECT_NEAR(width(TaperedGaussian{}, 1.4) / width(ImprovedGaussian{}, 1.23), 0.96, 0.01);
    const double cutOff = std::abs(shareOfTheLattice(ImprovedGaussian{}, 1.23));
    EXPECT_NEAR(cutOff, 1.0e-5, 2e-6);
    EXPECT_LT(std::abs(shareOfTheLattice(TaperedGaussian{}, 1.4)), 0.1 * cutOff);
}

TEST(Kernels, HaveTheGradientThatDifferencesOfWGive)
{
    constexpr double h = 0.7, step = 1e-5;
    for (const int dim : {2, 3})
    {
        for (const auto& choice : allKernels())
        {
            const Kernel kernel(choice, dim, h);
            for (double r = 0.013; r < kernel.supportRadius() - 2 * step; r += 0.0171)
            {
                const double difference = (kernel.W(r + step) - kernel.W(r - step)) / (2 * step);
                EXPECT_NEAR(kernel.gradFactor(r) * r, difference, 1e-7 * kernel.W(0) / h)
                    << kernel.name() << " r " << r;
            }
        }
    }
}

TEST(Kernels, AreZeroFromTheSupportRadiusOn)
{
    for (const auto& choice : allKernels())
    {
        const Kernel kernel(choice, 2, 0.5);
        EXPECT_EQ(kernel.W(kernel.supportRadius()), 0);
        EXPECT_EQ(kernel.W(1.5 * kernel.supportRadius()), 0);
        EXPECT_EQ(kernel.gradFactor(1.5 * kernel.supportRadius()), 0);
        EXPECT_GT(kernel.W(0.99 * kernel.supportRadius()), 0);
    }
}

/// A lane.
template <class S>
RealOf<S> one(const S& x)
{
    if constexpr (lanesOf<S> == 1)
    {
        return x;
    }
    else
    {
        return x[0];
    }
}

template <class K, class S>
void expectSameAsDouble(double tolerance)
{
    const double scale = K::f(0.0);
    // From far inside to far outside the support, the distance of padding included.
    for (double q = 0; q < 40; q = q < 4 ? q + 0.003 : 2 * q)
    {
        const S q2(static_cast<RealOf<S>>(q * q));
        const double exactQ2 = static_cast<double>(static_cast<RealOf<S>>(q * q));
        const S f = K::f(q2);
        EXPECT_NEAR(static_cast<double>(one(f)), K::f(exactQ2), tolerance * scale) << K::name << " q " << q;
        if (q > 0)
        {
            const S dfByQ = K::dfByQ(q2);
            EXPECT_NEAR(static_cast<double>(one(dfByQ)), K::dfByQ(exactQ2), 4 * tolerance * std::abs(K::dfByQ(1e-6)))
                << K::name << " q " << q;
        }
        if (q >= K::supportRatio + 1e-6)
        {
            EXPECT_EQ(one(f), 0) << K::name << " q " << q;
            EXPECT_EQ(one(S(K::dfByQ(q2))), 0) << K::name << " q " << q;
        }
    }
}

TEST(Kernels, AreTheSameInFloatAndInVectorsAsInTheReference)
{
    forEveryKernel(
        []<class K>()
        {
            const bool exponential = K::name == "improvedGaussian" || K::name == "taperedGaussian";
            // Differences of fifth powers; a power of a power (base/simd.hpp).
            const double single = K::name == "quinticSpline" ? 2e-6 : exponential ? 1e-6 : 4e-7;
            expectSameAsDouble<K, float>(single);
            expectSameAsDouble<K, Simd<float>>(single);
            expectSameAsDouble<K, Simd<double>>(exponential ? 1e-13 : 1e-14);
        }
    );
}

/// The probe of Cao et al. 2014, Fig. 2: f = x^2 + y^2 on [0, 2]^2, particles on the nodes, the probe displaced along
/// the diagonal.
TEST(Kernels, ReproduceTheAccuracyTestOfThePaper)
{
    // Cao et al. 2014, Fig. 2: errors of f at d/dx = 0, 0.1 ... 0.5; the constants there are exact to the digits
    // printed.
    const std::vector<std::pair<KernelChoice, std::vector<double>>> table = {
        {CubicSpline{}, {.00838, .00782, .00745, .00855, .01103, .01384}},
        {WendlandC2{}, {.0390, .0337, .0232, .0112, .0005, -.0075}},
        {QuinticSpline{}, {.01446, .01446, .01450, .01457, .01467, .01477}},
        {ImprovedGaussian{}, {.01508, .01510, .01511, .01509, .01503, .01496}}};
    constexpr double dx = 0.1;
    for (const auto& [choice, errors] : table)
    {
        const Kernel kernel(choice, 2, 1.23 * dx);
        for (std::size_t k = 0; k < errors.size(); ++k)
        {
            const double x = 1 + 0.1 * static_cast<double>(k) * dx / std::numbers::sqrt2;
            double sum = 0;
            for (int i = 0; i <= 20; ++i)
            {
                for (int j = 0; j <= 20; ++j)
                {
                    const double xb = i * dx, yb = j * dx;
                    sum += (xb * xb + yb * yb) * kernel.W(std::hypot(x - xb, x - yb)) * dx * dx;
                }
            }
            EXPECT_NEAR(sum - 2 * x * x, errors[k], 1e-4) << kernel.name() << " d/dx 0." << k;
        }
    }
}

TEST(Kernel, IsReadWithThePapersSmoothingLengthByDefault)
{
    const auto dict = Dictionary::parse("kernel improvedGaussian;", "constant/kernelProperties");
    EXPECT_DOUBLE_EQ(Kernel::read(dict, 2, 0.01).smoothingLength(), 0.0123);
    EXPECT_DOUBLE_EQ(Kernel::read(dict, 3, 0.01).smoothingLength(), 0.01);
    EXPECT_EQ(Kernel::read(dict, 2, 0.01).name(), "improvedGaussian");
    EXPECT_DOUBLE_EQ(Kernel::read(dict, 2, 0.01).supportRadius(), 0.0369);
}

TEST(Kernel, RefusesAnUnknownNameWithTheNearestOne)
{
    const auto dict = Dictionary::parse("\n\nkernel gausian;", "constant/kernelProperties");
    try
    {
        Kernel::read(dict, 2, 0.01);
        FAIL() << "accepted";
    }
    catch (const CaseError& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("constant/kernelProperties:3: unknown kernel type 'gausian'"), std::string::npos) << text;
        EXPECT_NE(
            text.find("Valid kernel types: cubicSpline improvedGaussian quinticSpline taperedGaussian wendlandC2"),
            std::string::npos
        ) << text;
    }
}

} // namespace
} // namespace slosh
