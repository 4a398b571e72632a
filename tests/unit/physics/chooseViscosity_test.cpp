// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/chooseViscosity.hpp"

#include <gtest/gtest.h>

namespace slosh
{
namespace
{

TEST(ChooseViscosity, OfEachNameIsTheTermThatHasThisName)
{
    EXPECT_EQ(FluidProperties::viscosities().size(), std::variant_size_v<ViscosityChoice>);
    for (const auto& viscosity : FluidProperties::viscosities())
    {
        const auto fluid = FluidProperties::read(Dictionary::parse(
            "rho0 1000; viscosity { type " + std::string(viscosity.name) + "; alpha 0.03; nu 1e-6; }",
            "constant/fluidProperties"
        ));
        const ViscosityChoice chosen = chooseViscosity(fluid, {1000, 10, 7}, 0.01);
        EXPECT_EQ(std::visit([](const auto& term) { return term.name; }, chosen), viscosity.name);
    }
}

} // namespace
} // namespace slosh
