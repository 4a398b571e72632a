// SPDX-License-Identifier: GPL-3.0-or-later
// What a user can get wrong in system/kernelAccuracyDict.
#include "KernelAccuracyCase.hpp"

namespace slosh
{
namespace
{

using BadKernelAccuracy = KernelAccuracy;

TEST_F(BadKernelAccuracy, UnknownKernelIsAnsweredWithTheNearestAndTheValidOnes)
{
    expectRefused(
        "wendlandC2", "wendlandC4",
        {"system/kernelAccuracyDict:12: unknown kernel type 'wendlandC4'", "did you mean 'wendlandC2'?",
         "cubicSpline improvedGaussian quinticSpline taperedGaussian wendlandC2"}
    );
    expectRefused("(cubicSpline wendlandC2 quinticSpline improvedGaussian)", "()", {"kernels is empty"});
}

TEST_F(BadKernelAccuracy, SpacingMustBePositiveFitTheDomainAndNotBeTiny)
{
    for (const std::string spacing : {"0", "-0.1", "nan"})
    {
        expectRefused("spacing         0.1;", "spacing " + spacing + ";", {"spacing is " + spacing, "> 0 [m]"});
    }
    expectRefused(
        "spacing         0.1;", "spacing 0.03;", {"domain is not a whole number of spacings", "kernelAccuracyDict:11"}
    );
    expectRefused("spacing         0.1;", "spacing 1e-4;", {"spacing is too small", "200 spacings"});
}

TEST_F(BadKernelAccuracy, DomainMustHoldTheSupportAroundEveryProbe)
{
    // On either side 3 x 1.23 + 0.5 = 4.19 spacings; perturbed 3.69 + 6.25 + 0.1 = 10.04.
    expectRefused(
        "domain          2;", "domain 0.8;",
        {"domain is 0.8 m; the kernels' supports", "regular2D need at least 0.838 m", "kernelAccuracyDict:11"}
    );
    expectRefused("largest         0.5;", "largest 6.25;", {"perturbed2D need at least 2.008 m"});
}

TEST_F(BadKernelAccuracy, LatticeIsRegularOrPerturbedOfDimensionTwoOrThree)
{
    expectRefused("dimension       3;", "dimension 4;", {"dimension is 4", "2", "3", "kernelAccuracyDict:4"});
    expectRefused("dimension       3;", "dimension 2.5;", {"dimension is 2.5"});
    expectRefused(
        "type            perturbed;", "type perturbd;",
        {"unknown lattice type 'perturbd'", "did you mean 'perturbed'?", "perturbed regular"}
    );
    expectRefused("amplitude       0.1;", "amplitude 0;", {"amplitude is 0"});
    expectRefused("amplitude       0.1;", "amplitude 0.6;", {"amplitude is 0.6", "0.5"});
    expectRefused("samples         20;", "samples 1;", {"samples is 1"});
    expectRefused("seed            2014;", "sead 2014;", {"sead", "seed"});
}

TEST_F(BadKernelAccuracy, DirectionMustNotVanishInThePlane)
{
    expectRefused("(1 1 1)", "(0 0 1)", {"direction is (0 0 0) in the plane of regular2D"});
}

TEST_F(BadKernelAccuracy, MissingDictionaryIsNamed)
{
    case_.remove(dictionary);
    EXPECT_NE(case_.run("kernelAccuracy").err.find(dictionary), std::string::npos);
}

} // namespace
} // namespace slosh
