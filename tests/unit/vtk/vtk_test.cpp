// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/CaseError.hpp"
#include "dictionary/Dictionary.hpp"
#include "vtk/writeSeries.hpp"
#include "vtk/writeTankOutline.hpp"
#include "vtk/writeVtu.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// A fresh directory for each test.
class VtkFiles : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string name = (fs::temp_directory_path() / "vtkFilesXXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    static std::string textOf(const fs::path& file)
    {
        std::ifstream in(file, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    fs::path folder_;
};

/// Values that need every digit, so that an array written in single precision or mixed up with another is noticed.
Particles sampleParticles(std::ptrdiff_t nFluid, std::ptrdiff_t nWall)
{
    Particles particles;
    particles.resize(nFluid, nWall);
    for (std::ptrdiff_t i = 0; i < particles.size(); ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        const double x = static_cast<double>(i + 1);
        particles.r[k] = {x / 3, -x / 7, x / 11};
        particles.v[k] = {x / 13, x / 17, -x / 19};
        particles.p[k] = 1000 * x / 23;
        particles.rho[k] = 1000 + x / 29;
        particles.id[k] = static_cast<int>(1000 - i);
    }
    return particles;
}

vtkUnstructuredGrid* readGrid(vtkXMLUnstructuredGridReader& reader, const fs::path& file)
{
    EXPECT_EQ(reader.CanReadFile(file.c_str()), 1);
    reader.SetFileName(file.c_str());
    reader.Update();
    EXPECT_EQ(reader.GetErrorCode(), 0u);
    return reader.GetOutput();
}

TEST_F(VtkFiles, AreReadBackByVtkWithTheSameBits)
{
    const std::ptrdiff_t nFluid = 500, nWall = 300;
    const Particles particles = sampleParticles(nFluid, nWall);
    writeVtu(folder_ / "fluid.vtu", particles, ParticleRange::liquid, usualFields(), 0.1);
    writeVtu(folder_ / "wall.vtu", particles, ParticleRange::wall, usualFields(), 0.1);

    for (const auto& [name, first, n] :
         {std::tuple("fluid.vtu", std::ptrdiff_t{0}, nFluid), {"wall.vtu", nFluid, nWall}})
    {
        vtkNew<vtkXMLUnstructuredGridReader> reader;
        vtkUnstructuredGrid* grid = readGrid(*reader, folder_ / name);
        ASSERT_EQ(grid->GetNumberOfPoints(), n);
        ASSERT_EQ(grid->GetNumberOfCells(), n);
        vtkPointData* data = grid->GetPointData();
        EXPECT_EQ(data->GetNumberOfArrays(), 4);
        vtkDataArray* U = data->GetArray("U");
        vtkDataArray* p = data->GetArray("p");
        vtkDataArray* rho = data->GetArray("rho");
        vtkDataArray* id = data->GetArray("origId");
        ASSERT_TRUE(U && p && rho && id);
        ASSERT_EQ(U->GetNumberOfComponents(), 3);
        for (std::ptrdiff_t i = 0; i < n; ++i)
        {
            const auto k = static_cast<std::size_t>(first + i);
            EXPECT_EQ(Vec(grid->GetPoint(i)), particles.r[k]);
            EXPECT_EQ(Vec(U->GetTuple3(i)), particles.v[k]);
            EXPECT_EQ(p->GetTuple1(i), particles.p[k]);
            EXPECT_EQ(rho->GetTuple1(i), particles.rho[k]);
            EXPECT_EQ(id->GetTuple1(i), particles.id[k]);
            EXPECT_EQ(grid->GetCellType(i), VTK_VERTEX);
            EXPECT_EQ(grid->GetCell(i)->GetPointId(0), i);
        }
    }
}

TEST_F(VtkFiles, CarryTheInstantTheyShow)
{
    writeVtu(folder_ / "fluid.vtu", sampleParticles(3, 0), ParticleRange::liquid, {"p"}, 1.0 / 3);
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    vtkDataArray* time = readGrid(*reader, folder_ / "fluid.vtu")->GetFieldData()->GetArray("TimeValue");
    ASSERT_TRUE(time);
    EXPECT_EQ(time->GetTuple1(0), 1.0 / 3);
}

TEST_F(VtkFiles, AreBinaryAppendedAndCompressed)
{
    Particles particles = sampleParticles(20000, 0);
    particles.p.assign(20000, 1000.0);
    writeVtu(folder_ / "fluid.vtu", particles, ParticleRange::liquid, {"p"}, 0);
    const std::string text = textOf(folder_ / "fluid.vtu");
    EXPECT_NE(text.find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
    EXPECT_NE(text.find("<AppendedData encoding=\"raw\">"), std::string::npos);
    EXPECT_EQ(text.find("format=\"ascii\""), std::string::npos);
    EXPECT_EQ(text.find("format=\"binary\""), std::string::npos);
    // Points need 24 bytes a particle and hardly shrink; the even p, offsets, types and connectivity (8 + 8 + 1 + 8)
    // do.
    EXPECT_LT(text.size(), 20000u * 30);
}

TEST_F(VtkFiles, HoldOnlyTheFieldsAskedFor)
{
    writeVtu(folder_ / "fluid.vtu", sampleParticles(5, 0), ParticleRange::liquid, {"rho", "p"}, 0);
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    vtkPointData* data = readGrid(*reader, folder_ / "fluid.vtu")->GetPointData();
    EXPECT_EQ(data->GetNumberOfArrays(), 2);
    EXPECT_TRUE(data->HasArray("rho"));
    EXPECT_TRUE(data->HasArray("p"));
}

TEST_F(VtkFiles, MayHoldNoParticleAtAll)
{
    writeVtu(folder_ / "wall.vtu", sampleParticles(5, 0), ParticleRange::wall, usualFields(), 0);
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    EXPECT_EQ(readGrid(*reader, folder_ / "wall.vtu")->GetNumberOfPoints(), 0);
}

TEST_F(VtkFiles, RefuseAFieldThatDoesNotExistAndNameTheNearest)
{
    try
    {
        writeVtu(folder_ / "fluid.vtu", sampleParticles(5, 0), ParticleRange::liquid, {"rhoo"}, 0);
        FAIL() << "accepted";
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("did you mean 'rho'"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(VtkFiles, LeaveNothingBehindWhereTheyCannotBeWritten)
{
    std::ofstream(folder_ / "VTK") << "a file where the folder should be";
    EXPECT_THROW(
        writeVtu(folder_ / "VTK/fluid.vtu", sampleParticles(5, 0), ParticleRange::liquid, {"p"}, 0), CaseError
    );
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(VtkFiles, SeriesNamesEveryFileAndItsTimeWithAllDigits)
{
    writeSeries(folder_ / "fluid.vtu.series", {{"fluid_0.vtu", 0}, {"fluid_17.vtu", 0.1}, {"fluid_30.vtu", 1.0 / 3}});
    EXPECT_EQ(
        textOf(folder_ / "fluid.vtu.series"), "{\n"
                                              "  \"file-series-version\" : \"1.0\",\n"
                                              "  \"files\" : [\n"
                                              "    { \"name\" : \"fluid_0.vtu\", \"time\" : 0 },\n"
                                              "    { \"name\" : \"fluid_17.vtu\", \"time\" : 0.1 },\n"
                                              "    { \"name\" : \"fluid_30.vtu\", \"time\" : 0.3333333333333333 }\n"
                                              "  ]\n"
                                              "}\n"
    );
}

/// The tank turned by 30 deg about x and lifted by 2 m.
RigidState turnedTank()
{
    RigidState state;
    state.R = Eigen::AngleAxisd(std::numbers::pi / 6, Vec::UnitX()).toRotationMatrix();
    state.c = {0, 0, 2};
    return state;
}

Tank tankOf(const std::string& plane)
{
    return Tank::read(Dictionary::parse(
        "type box; " + plane + " min (-0.5 -1 0); max (0.5 1 3); fillDepth 1;", "constant/tankProperties"
    ));
}

std::set<std::vector<double>> cornersOf(const TankOutline& outline)
{
    std::set<std::vector<double>> corners;
    for (const Vec& x : outline.corners)
    {
        corners.insert({x.x(), x.y(), x.z()});
    }
    return corners;
}

TEST_F(VtkFiles, OutlineOfATwoDimensionalTankIsARectangleInTheMiddleOfTheSlice)
{
    const TankOutline outline(tankOf("plane yz;"), {Frame::inertial, {}});
    EXPECT_EQ(cornersOf(outline), (std::set<std::vector<double>>{{0, -1, 0}, {0, 1, 0}, {0, -1, 3}, {0, 1, 3}}));
    EXPECT_EQ(outline.edges.size(), 4u);
}

TEST_F(VtkFiles, OutlineEdgesKeepTheirLengthsInTheMovingTankAndAreReadBackByVtk)
{
    const TankOutline outline(tankOf(""), {Frame::inertial, turnedTank()});
    writeTankOutline(folder_ / "tank.vtp", outline, 0.5);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder_ / "tank.vtp").c_str());
    reader->Update();
    vtkPolyData* poly = reader->GetOutput();
    ASSERT_EQ(poly->GetNumberOfPoints(), 8);
    ASSERT_EQ(poly->GetNumberOfLines(), 12);
    std::multiset<long> lengths;
    for (vtkIdType i = 0; i < 12; ++i)
    {
        vtkCell* line = poly->GetCell(i);
        const Vec a(poly->GetPoint(line->GetPointId(0))), b(poly->GetPoint(line->GetPointId(1)));
        lengths.insert(std::lround(1e9 * (a - b).norm()));
    }
    EXPECT_EQ(
        lengths, (std::multiset<long>{
                     1000000000, 1000000000, 1000000000, 1000000000, 2000000000, 2000000000, 2000000000, 2000000000,
                     3000000000, 3000000000, 3000000000, 3000000000})
    );
    // The bottom's far edge, y = 1: (y, z) = (cos 30, 2 + sin 30).
    double highestOfBottom = 0;
    for (const Vec& x : outline.corners)
    {
        if (x.y() > 0.8)
        {
            highestOfBottom = x.z();
            EXPECT_NEAR(x.y(), std::sqrt(3) / 2, 1e-12);
        }
    }
    EXPECT_NEAR(highestOfBottom, 2.5, 1e-12);
}

TEST_F(VtkFiles, OutlineStaysPutInTheTankFrame)
{
    EXPECT_EQ(
        cornersOf(TankOutline(tankOf(""), {Frame::tank, turnedTank()})),
        cornersOf(TankOutline(tankOf(""), {Frame::inertial, {}}))
    );
}

} // namespace
} // namespace slosh
