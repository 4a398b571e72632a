// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fillTank.hpp"
#include "fluid/TaitEquation.hpp"
#include "particles/changeFrame.hpp"
#include "particles/particleFiles.hpp"
#include "particles/particlesOutside.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"
#include "dictionary/Dictionary.hpp"

#include <gtest/gtest.h>

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
    changeFrame(p, {Frame::tank, tank}, Frame::inertial);
    EXPECT_NEAR((p.r[1] - tank.pointToInertial(before.r[1])).norm(), 0, 1e-15);
    EXPECT_NEAR((p.v[1] - (tank.velocityAt(before.r[1]) + tank.R * before.v[1])).norm(), 0, 1e-15);
    changeFrame(p, {Frame::inertial, tank}, Frame::tank);
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
    EXPECT_TRUE(particlesOutside(tank, p, {Frame::tank, state}).empty());
    p.r[7] = Vec(0, 0.47, 0.1);
    p.r[8].z() = -0.007; // less than dx/2 deep
    p.r[9].z() = -0.008;
    const std::vector<std::ptrdiff_t> expected{7, 9};
    EXPECT_EQ(particlesOutside(tank, p, {Frame::tank, state}), expected);
    changeFrame(p, {Frame::tank, state}, Frame::inertial);
    EXPECT_EQ(particlesOutside(tank, p, {Frame::inertial, state}), expected);
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
    state.stops = {{Vec(1.0 / 3, 2, 3), Vec(4, 1.0 / 7, 6)}, {}};
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
    ASSERT_EQ(back.stops.size(), 2);
    EXPECT_EQ(back.stops[0].force, state.stops[0].force);
    EXPECT_EQ(back.stops[0].moment, state.stops[0].moment);
    EXPECT_NO_THROW(back.requireStopsOn(2));
    EXPECT_THROW(back.requireStopsOn(1), CaseError) << "of another tank";
    state.budget.reset();
    state.stops.clear();
    writeTime(theCase, "0.4", before, state, {WriteFormat::binary, 6});
    readTime(theCase, "0.4", back);
    EXPECT_FALSE(back.budget);
    EXPECT_TRUE(back.stops.empty());
    EXPECT_NO_THROW(back.requireStopsOn(1)) << "nothing was stopped";
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
    fs::copy_file(
        root / "4/lagrangian/wall/rho", root / "4/lagrangian/fluid/rho", fs::copy_options::overwrite_existing
    );
    EXPECT_THROW(readTime(theCase, "4", back), CaseError) << "two values for three particles";
}

} // namespace
} // namespace slosh
