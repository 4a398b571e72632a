// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscosities/readViscosity.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

const TaitEquation state{1000, 10, 7};

ViscosityChoice viscosity(const std::string& entries)
{
    return readViscosity(Dictionary::parse(entries, "viscosity"), state);
}

TEST(ReadViscosity, OfEachNameIsTheTypeThatHasThisName)
{
    EXPECT_EQ(viscosityTypes().size(), std::variant_size_v<ViscosityChoice>);
    for (const ViscosityType& type : viscosityTypes())
    {
        // Coefficients of the others may stand there.
        const std::string name(type.name);
        const ViscosityChoice read = viscosity("type " + name + "; alpha 0.03; nu 1e-6; walls slip;");
        EXPECT_EQ(std::visit([](const auto& is) { return is.name; }, read), name);
    }
    EXPECT_TRUE(isNone(ViscosityChoice())) << "what a scene has that names none";
}

TEST(ReadViscosity, TakesCoefficientsAndWhatTheLiquidSays)
{
    const auto artificial = std::get<ArtificialViscosity>(viscosity("type artificial; alpha 0.03;"));
    EXPECT_EQ(artificial.alpha, 0.03);
    EXPECT_EQ(artificial.c0, 10);
    EXPECT_EQ(artificial.rho0, 1000);
    EXPECT_EQ(std::get<LaminarViscosity>(viscosity("type laminar; nu [0 2 -1 0 0 0 0] 1e-6;")).nu, 1e-6);
    EXPECT_EQ(std::get<LowDissipationRiemann>(viscosity("type lowDissipationRiemann;")).c0, 10);
    EXPECT_EQ(describe(viscosity("type laminar; nu 1e-6;")), "laminar, nu = 1e-06 m^2/s");
    EXPECT_EQ(describe(viscosity("type artificial; alpha 0.03;")), "artificial, alpha = 0.03");
}

TEST(ReadViscosity, RefusesWhatIsNone)
{
    EXPECT_THROW(viscosity("alpha 0.03;"), CaseError);
    EXPECT_THROW(viscosity("type artificial;"), CaseError);
    EXPECT_THROW(viscosity("type artificial; alpha -1;"), CaseError);
    EXPECT_THROW(viscosity("type artificial; alpha 0.03; beta 1;"), CaseError);
    EXPECT_THROW(viscosity("type artifical; alpha 0.03;"), CaseError);
}

} // namespace
} // namespace slosh
