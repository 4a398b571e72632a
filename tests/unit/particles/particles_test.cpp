// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/Lattice.hpp"
#include "particles/TaitEquation.hpp"
#include "particles/changeFrame.hpp"
#include "particles/initialFields.hpp"
#include "particles/particleFiles.hpp"
#include "particles/particlesOutside.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "dictionary/Dictionary.hpp"
#include "particles/FluidProperties.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>
#include <unistd.h>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

Tank tankOf(const std::string& text)
{
    return Tank::read(Dictionary::parse(text, "constant/tankProperties"));
}

const std::string rolling = "type box; plane yz; min (-0.5 -0.46 0); max (0.5 0.46 0.62); fillDepth 0.155; ";
constexpr TaitEquation tait{1000, 20, 7};

TEST(TaitEquation, IsItsOwnInverse)
{
    for (const double gamma : {1.0, 7.0, 4.5})
    {
        const TaitEquation eos{998, 15, gamma};
        for (const double p : {-2000.0, 0.0, 50.0, 3e4})
        {
            EXPECT_NEAR(eos.p(eos.rho(p)), p, 1e-8) << gamma;
        }
        const double h = 1e-3; // c^2 = dp/drho at rho0
        EXPECT_NEAR((eos.p(998 + h) - eos.p(998 - h)) / (2 * h), 15 * 15, 1e-5) << gamma;
    }
}

TEST(TaitEquation, ColumnIsInEquilibriumAndDepthInvertsIt)
{
    for (const double gamma : {1.0, 7.0})
    {
        const TaitEquation eos{1000, 12, gamma};
        EXPECT_EQ(eos.hydrostatic(9.81, 0), 0);
        for (const double d : {0.05, 0.3, 1.0})
        {
            const double h = 1e-5;
            const double slope = (eos.hydrostatic(9.81, d + h) - eos.hydrostatic(9.81, d - h)) / (2 * h);
            EXPECT_NEAR(slope, eos.rho(eos.hydrostatic(9.81, d)) * 9.81, 1e-4);
            EXPECT_NEAR(eos.depth(9.81, eos.hydrostatic(9.81, d)), d, 1e-13);
        }
    }
}

TEST(FluidProperties, ColumnWeighsWhatTheRealOneDoes)
{
    const FluidProperties fluid = FluidProperties::read(Dictionary::parse(
        "rho0 998; equationOfState { speedOfSound 10; } viscosity { type none; }", "constant/fluidProperties"));
    const Tank tank = tankOf(rolling);
    const TaitEquation eos = fluid.equationOfState(tank, Vec(0, 0, -9.81), *SolidBodyMotion::stationary());
    EXPECT_LT(eos.rho0, 998);
    EXPECT_NEAR(eos.hydrostatic(9.81, 0.155), 998 * 9.81 * 0.155, 1e-6); // the bottom carries the weight
}

TEST(FillTank, HoldsTheExactMassWhateverTheSpacing)
{
    const Tank tank = tankOf(rolling);
    for (const double dx : {0.155 / 15, 0.01, 0.0123, 0.031})
    {
        const Filling filling = fillTank(tank, dx, 4, 998, tait, 9.81, 3.69);
        const Particles& p = filling.particles;
        EXPECT_NEAR(p.mass * static_cast<double>(p.nFluid), 998 * 0.92 * 0.155, 1e-11) << dx;
        for (std::ptrdiff_t i = 0; i < p.nFluid; ++i)
        {
            EXPECT_GT(tank.distanceToWall(p.r[static_cast<std::size_t>(i)]), 0.4 * dx * 0.9);
        }
        for (std::ptrdiff_t i = p.nFluid; i < p.size(); ++i)
        {
            EXPECT_LT(tank.distanceToWall(p.r[static_cast<std::size_t>(i)]), 0);
        }
    }
    EXPECT_TRUE(fillTank(tankOf("type box; min (0 0 0); max (1 1 1); fillDepth 0.5;"), 0.1, 4, 998, tait, 0, 2)
                    .adjustments.empty());
    EXPECT_FALSE(fillTank(tank, 0.0123, 4, 998, tait, 9.81, 3.69).adjustments.empty());
}

TEST(FillTank, SurroundsTheLiquidWithTheLayersAskedFor)
{
    // 1 x 1 x 0.5 of 0.1: 10 x 10 x 5 liquid cells in a closed shell of L layers around 10 x 10 x 10.
    const Tank tank = tankOf("type box; min (0 0 0); max (1 1 1); fillDepth 0.5;");
    for (const int layers : {1, 3, 4})
    {
        const Particles p = fillTank(tank, 0.1, layers, 1000, tait, 0, 2).particles;
        EXPECT_EQ(p.nFluid, 500);
        const long edge = 10 + 2 * layers;
        EXPECT_EQ(p.nWall, edge * edge * edge - 1000);
    }
}

TEST(FillTank, StartsWithThePressureOfTheColumn)
{
    const Tank tank = tankOf(rolling);
    const Particles p = fillTank(tank, 0.155 / 15, 4, 1000, tait, 9.81, 3.69).particles;
    for (std::size_t i = 0; i < static_cast<std::size_t>(p.nFluid); ++i)
    {
        const double depth = 0.155 - p.r[i].z();
        EXPECT_NEAR(p.p[i], 1000 * 9.81 * depth, 0.01 * 1000 * 9.81 * 0.155);
        EXPECT_NEAR(p.rho[i], tait.rho(p.p[i]), 1e-9);
        EXPECT_EQ(p.v[i], Vec(0, 0, 0));
    }
}

TEST(FillTank, MakesADropInFreeSpaceSymmetricAndOfExactMass)
{
    const Tank tank = tankOf("type box; min (-2 -2 -2); max (2 2 2); "
                             "liquid { drop { type searchableSphere; centre (0 0 0); radius 1; } }");
    const Filling filling = fillTank(tank, 0.1, 0, 998, tait, 0, 3);
    const Particles& p = filling.particles;
    EXPECT_EQ(p.nWall, 0);
    EXPECT_NEAR(p.mass * static_cast<double>(p.nFluid), 998 * 4.0 / 3.0 * std::acos(-1.0), 1e-9);
    Vec centre = Vec::Zero();
    for (const Vec& r : p.r)
    {
        EXPECT_LT(r.norm(), 1);
        centre += r;
    }
    EXPECT_LT(centre.norm(), 1e-9);
    EXPECT_NEAR(p.spacing, 0.1, 2e-3);
}

TEST(InitialFields, AreFormulasInTheTanksCoordinates)
{
    const Tank tank = tankOf("type box; plane xz; min (-2 0 -2); max (2 1 2); "
                             "liquid { patch { type searchableSphere; centre (0 0 0); radius 1; } }");
    Particles p = fillTank(tank, 0.1, 0, 1000, tait, 0, 3).particles;
    const auto set = [&](const std::string& text)
    { setInitialFields(Dictionary::parse(text, "system/blockParticlesDict/initialFields"), tank, tait, p); };
    set("U (\"-2*x\" \"17\" \"2*z + sqr(x)\"); p \"500*(1 - x^2 - z^2)\";");
    for (std::size_t i = 0; i < p.r.size(); ++i)
    {
        const double x = p.r[i].x(), z = p.r[i].z();
        EXPECT_DOUBLE_EQ(p.v[i].x(), -2 * x);
        EXPECT_EQ(p.v[i].y(), 0); // the empty direction
        EXPECT_NEAR(p.v[i].z(), 2 * z + x * x, 1e-14);
        EXPECT_NEAR(p.p[i], 500 * (1 - x * x - z * z), 1e-10);
        EXPECT_NEAR(tait.p(p.rho[i]), p.p[i], 1e-7);
    }
    EXPECT_THROW(set("U (\"x\" \"0\");"), CaseError);
    EXPECT_THROW(set("p \"1/(x - x)\";"), CaseError);
    EXPECT_THROW(set("p \"2*w\";"), CaseError);
    EXPECT_THROW(set("p \"-1e9\";"), CaseError);
    EXPECT_THROW(set("pressure \"1\";"), CaseError);
}

TEST(FillTank, RefusesWhatTheKernelCannotSee)
{
    const Tank thin = tankOf(rolling + "geometry { b { type searchableBox; min (-1 -0.01 0); max (1 0.01 0.1); } }");
    EXPECT_THROW(fillTank(thin, 0.01, 4, 1000, tait, 9.81, 3.69), CaseError);
    EXPECT_NO_THROW(fillTank(thin, 0.005, 4, 1000, tait, 9.81, 3.69));
    EXPECT_THROW(fillTank(tankOf(rolling), 0.5, 4, 1000, tait, 9.81, 3.69), CaseError);
}

RigidState somewhere()
{
    RigidState state;
    state.c = Vec(0.1, -0.2, 0.3);
    state.R = Eigen::AngleAxisd(0.3, Vec(1, 2, 3).normalized()).toRotationMatrix();
    state.velocity = Vec(1, 2, -1);
    state.omega = Vec(0.5, -0.4, 2);
    return state;
}

Particles threeAndTwo()
{
    Particles p;
    p.resize(3, 2);
    p.mass = 0.1;
    p.spacing = 0.01;
    for (std::size_t i = 0; i < 5; ++i)
    {
        const double s = static_cast<double>(i) + 1;
        p.r[i] = Vec(1 / s, s / 7, -s / 3);
        p.v[i] = Vec(s, -1 / s, 0.1);
        p.rho[i] = 1000 + 1 / s;
        p.p[i] = 1e4 / 3 / s;
        p.id[i] = static_cast<int>(i < 3 ? i : i - 3);
    }
    return p;
}

TEST(ChangeFrame, GoesThereAndBack)
{
    const RigidState tank = somewhere();
    const Particles before = threeAndTwo();
    Particles p = before;
    changeFrame(p, tank, Frame::tank, Frame::inertial);
    EXPECT_NEAR((p.r[1] - tank.pointToInertial(before.r[1])).norm(), 0, 1e-15);
    EXPECT_NEAR((p.v[1] - (tank.velocityAt(before.r[1]) + tank.R * before.v[1])).norm(), 0, 1e-15);
    changeFrame(p, tank, Frame::inertial, Frame::tank);
    for (std::size_t i = 0; i < 5; ++i)
    {
        EXPECT_NEAR((p.r[i] - before.r[i]).norm(), 0, 1e-14);
        EXPECT_NEAR((p.v[i] - before.v[i]).norm(), 0, 1e-14);
    }
}

TEST(ParticlesOutside, FindsThemInEitherFrame)
{
    const Tank tank = tankOf(rolling);
    Particles p = fillTank(tank, 0.0155, 4, 1000, tait, 9.81, 3.69).particles;
    const RigidState state = somewhere();
    EXPECT_TRUE(particlesOutside(tank, p, Frame::tank, state).empty());
    p.r[7] = Vec(0, 0.47, 0.1);
    p.r[8].z() = -0.007; // less than dx/2 deep
    p.r[9].z() = -0.008;
    const std::vector<std::ptrdiff_t> expected{7, 9};
    EXPECT_EQ(particlesOutside(tank, p, Frame::tank, state), expected);
    changeFrame(p, state, Frame::tank, Frame::inertial);
    EXPECT_EQ(particlesOutside(tank, p, Frame::inertial, state), expected);
}

class ParticleFiles : public testing::Test
{
protected:
    void SetUp() override
    {
        root = fs::temp_directory_path() / ("slosh.particles." + std::to_string(::getpid()));
        fs::create_directories(root / "constant");
        fs::create_directories(root / "system");
    }
    void TearDown() override { fs::remove_all(root); }
    fs::path root;
};

bool sameBits(const std::vector<Vec>& a, const std::vector<Vec>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec)) == 0;
}

TEST_F(ParticleFiles, BinaryKeepsEveryBit)
{
    const Case theCase(root);
    const Particles before = threeAndTwo();
    TimeState state{0.1 + 0.2, 1234, 1.0 / 3000, Frame::inertial, somewhere()};
    state.budget = EnergyBudget{0.1, 1.0 / 3, 1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13, -1.0 / 17, 1.0 / 19, 1.0 / 23};
    writeTime(theCase, "0.3", before, state, {WriteFormat::binary, 6});
    TimeState back;
    const Particles after = readTime(theCase, "0.3", back);
    EXPECT_TRUE(sameBits(after.r, before.r));
    EXPECT_TRUE(sameBits(after.v, before.v));
    EXPECT_EQ(after.rho, before.rho);
    EXPECT_EQ(after.p, before.p);
    EXPECT_EQ(after.id, before.id);
    EXPECT_EQ(after.mass, before.mass);
    EXPECT_EQ(after.nFluid, 3);
    EXPECT_EQ(back.time, state.time);
    EXPECT_EQ(back.index, 1234);
    EXPECT_EQ(back.deltaT, state.deltaT);
    EXPECT_EQ(back.frame, Frame::inertial);
    EXPECT_EQ(back.tank.R, state.tank.R);
    EXPECT_EQ(back.tank.omega, state.tank.omega);
    ASSERT_TRUE(back.budget);
    EXPECT_EQ(std::memcmp(&*back.budget, &*state.budget, sizeof(EnergyBudget)), 0);
    state.budget.reset();
    writeTime(theCase, "0.4", before, state, {WriteFormat::binary, 6});
    readTime(theCase, "0.4", back);
    EXPECT_FALSE(back.budget);
}

TEST_F(ParticleFiles, AsciiKeepsTheDigitsAskedFor)
{
    const Case theCase(root);
    const Particles before = threeAndTwo();
    writeTime(theCase, "1", before, {}, {WriteFormat::ascii, 8});
    TimeState back;
    const Particles after = readTime(theCase, "1", back);
    for (std::size_t i = 0; i < 5; ++i)
    {
        EXPECT_NEAR(after.p[i], before.p[i], 1e-7 * before.p[i]);
        EXPECT_NEAR((after.r[i] - before.r[i]).norm(), 0, 1e-7);
    }
}

TEST_F(ParticleFiles, NameWhatIsWrongInThem)
{
    const Case theCase(root);
    Particles particles = threeAndTwo();
    TimeState back;
    particles.p[1] = std::nan("");
    writeTime(theCase, "1", particles, {}, {WriteFormat::ascii, 8});
    EXPECT_THROW(readTime(theCase, "1", back), CaseError);
    particles = threeAndTwo();
    particles.id[2] = 0;
    writeTime(theCase, "2", particles, {}, {WriteFormat::binary, 8});
    EXPECT_THROW(readTime(theCase, "2", back), CaseError);
    writeTime(theCase, "3", threeAndTwo(), {}, {WriteFormat::binary, 8});
    fs::resize_file(root / "3/lagrangian/fluid/U", fs::file_size(root / "3/lagrangian/fluid/U") - 9);
    EXPECT_THROW(readTime(theCase, "3", back), CaseError);
    writeTime(theCase, "4", threeAndTwo(), {}, {WriteFormat::binary, 8});
    fs::copy_file(root / "4/lagrangian/wall/rho", root / "4/lagrangian/fluid/rho",
                  fs::copy_options::overwrite_existing);
    EXPECT_THROW(readTime(theCase, "4", back), CaseError) << "two values for three particles";
}

} // namespace
} // namespace slosh
