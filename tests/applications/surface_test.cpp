// SPDX-License-Identifier: GPL-3.0-or-later
// particlesToVTK -surface as users start it, its files as VTK's own reader opens them.
#include "CaseDirectory.hpp"

#include "particles/particleFiles.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <numbers>
#include <regex>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;
using std::numbers::pi;

/// The file of a series that shows `time`, opened by VTK.
class SurfaceRead
{
public:
    SurfaceRead(const CaseDirectory& theCase, const std::string& time)
    {
        const std::string series = theCase.text("VTK/surface.vtp.series");
        std::smatch name;
        EXPECT_TRUE(std::regex_search(series, name, std::regex(R"x("(surface_\d+\.vtp)", "time" : )x" + time + " ")))
            << series;
        reader_->SetFileName((theCase.path() / "VTK" / name.str(1)).c_str());
        reader_->Update();
        EXPECT_EQ(reader_->GetErrorCode(), 0u);
    }
    vtkPolyData* operator->() const { return reader_->GetOutput(); }
    vtkIdType size() const { return reader_->GetOutput()->GetNumberOfPoints(); }
    Vec point(vtkIdType i) const { return Vec(reader_->GetOutput()->GetPoint(i)); }
    Vec U(vtkIdType i) const { return Vec(reader_->GetOutput()->GetPointData()->GetArray("U")->GetTuple3(i)); }
    double p(vtkIdType i) const { return reader_->GetOutput()->GetPointData()->GetArray("p")->GetTuple1(i); }
    BoundingBox box() const
    {
        BoundingBox box;
        for (vtkIdType i = 0; i < size(); ++i)
        {
            box.extend(point(i));
        }
        return box;
    }
    /// Length of lines, area of triangles.
    double extent() const
    {
        double sum = 0;
        for (vtkIdType c = 0; c < (*this)->GetNumberOfCells(); ++c)
        {
            vtkCell* cell = (*this)->GetCell(c);
            const auto x = [&](vtkIdType k) { return point(cell->GetPointId(k)); };
            if (cell->GetCellDimension() == 2)
            {
                sum += (x(1) - x(0)).cross(x(2) - x(0)).norm() / 2;
            }
            for (vtkIdType k = 1; cell->GetCellDimension() == 1 && k < cell->GetNumberOfPoints(); ++k)
            {
                sum += (x(k) - x(k - 1)).norm();
            }
        }
        return sum;
    }
    /// Volume in 3D, area in the xz plane, of closed surfaces.
    double enclosed() const
    {
        double sum = 0;
        for (vtkIdType c = 0; c < (*this)->GetNumberOfCells(); ++c)
        {
            vtkCell* cell = (*this)->GetCell(c);
            const auto x = [&](vtkIdType k) { return point(cell->GetPointId(k)); };
            if (cell->GetCellDimension() == 2)
            {
                sum += x(0).dot(x(1).cross(x(2))) / 6;
            }
            for (vtkIdType k = 1; cell->GetCellDimension() == 1 && k < cell->GetNumberOfPoints(); ++k)
            {
                sum += x(k - 1).cross(x(k)).y() / 2;
            }
        }
        return std::abs(sum);
    }

private:
    vtkNew<vtkXMLPolyDataReader> reader_;
};

/// Time 0 of a case, its surface.
SurfaceRead surfaceAtStart(const CaseDirectory& theCase)
{
    theCase.succeed("blockParticles");
    theCase.succeed("particlesToVTK -surface -noWall -frame tank -time 0");
    return {theCase, "0"};
}

/// Water at rest in the tank of a CaseDirectory, 0.2 m x 0.2 m x 0.15 m in 3D.
void atRest(const CaseDirectory& theCase, bool is3D)
{
    theCase.remove("constant/dynamicMeshDict");
    if (is3D)
    {
        theCase.edit(
            "constant/tankProperties", "plane yz;\nmin (-0.5 -0.1 0);\nmax (0.5 0.1 0.15)",
            "min (-0.1 -0.1 0);\nmax (0.1 0.1 0.15)"
        );
    }
}

constexpr double dx = 0.01; // of a CaseDirectory

TEST(FreeSurface, OfStillWaterIsFlatAtTheFillLevelAndEndsOnTheWalls)
{
    for (const bool is3D : {false, true})
    {
        // The share of a spacing by which linear interpolation and a kernel's sums over a lattice let the surface err.
        for (const auto& [kernel, share] :
             {std::pair("improvedGaussian", 0.035),
              {"quinticSpline", 0.035},
              {"taperedGaussian", 0.04},
              {"wendlandC2", 0.04},
              {"cubicSpline", 0.055}})
        {
            const CaseDirectory theCase;
            atRest(theCase, is3D);
            // The lattice has 15 steps from bottom to roof, and the level a fifth of a step above one of its points,
            // where what is linear between them errs most.
            theCase.edit("constant/tankProperties", "0.15)", "0.147)");
            theCase.edit("constant/kernelProperties", "improvedGaussian", std::string(kernel) + "; hOverDx 1.23");
            const SurfaceRead surface = surfaceAtStart(theCase);
            // No fold, no second sheet.
            EXPECT_NEAR(surface.extent(), is3D ? 0.2 * 0.2 : 0.2, 1e-3 * 0.2) << kernel;
            for (vtkIdType i = 0; i < surface.size(); ++i)
            {
                EXPECT_NEAR(surface.point(i).z(), 0.1, share * dx) << kernel << " at " << surface.point(i).transpose();
                EXPECT_EQ(surface.U(i), Vec::Zero());
                EXPECT_NEAR(surface.p(i), 0, 1.5 * share * 1000 * 9.81 * dx);
            }
            const BoundingBox box = surface.box();
            for (const int d : {0, 1})
            {
                const double end = d == 0 && !is3D ? 0 : 0.1;
                EXPECT_NEAR(box.min()[d], -end, 1e-7);
                EXPECT_NEAR(box.max()[d], end, 1e-7);
            }
        }
    }
}

TEST(FreeSurface, EndsOnTheSlantedSidesOfAPrism)
{
    for (const bool is3D : {false, true})
    {
        const CaseDirectory theCase;
        atRest(theCase, is3D);
        theCase.write(
            "constant/tankProperties",
            std::string("FoamFile { version 2.0; format ascii; class dictionary; }\ntype prism; ") +
                (is3D ? "extent (-0.1 0.1)" : "plane yz; extent (-0.5 0.5)") +
                "; section yz; fillDepth 0.1;\n"
                "polygon ((-0.05 0) (0.05 0) (0.13 0.16) (-0.2 0.15));"
        );
        const SurfaceRead surface = surfaceAtStart(theCase);
        // Where the sides are at z = 0.1: one rises 2:1, the other 1:1.
        EXPECT_NEAR(surface.extent(), 0.25 * (is3D ? 0.2 : 1), 0.02 * 0.25 * (is3D ? 0.2 : 1));
        const auto onLeft = [](const Vec& x) { return (x.y() + 0.05 + x.z()) / std::sqrt(2); };
        const auto onRight = [](const Vec& x) { return (0.05 + x.z() / 2 - x.y()) / std::sqrt(1.25); };
        double left = 1, right = 1; // nearest to the sides
        for (vtkIdType i = 0; i < surface.size(); ++i)
        {
            const Vec x = surface.point(i);
            left = std::min(left, onLeft(x));
            right = std::min(right, onRight(x));
            const bool isNearSide = std::min(onLeft(x), onRight(x)) < 3 * dx;
            EXPECT_NEAR(x.z(), 0.1, (isNearSide ? 0.35 : 0.1) * dx) << x.transpose();
        }
        EXPECT_NEAR(left, 0, 0.01 * dx);
        EXPECT_NEAR(right, 0, 0.01 * dx);
    }
}

TEST(FreeSurface, IsNowhereInATankThatIsFull)
{
    for (const bool is3D : {false, true})
    {
        const CaseDirectory theCase;
        atRest(theCase, is3D);
        theCase.edit("constant/tankProperties", "fillDepth 0.1", "fillDepth 0.15");
        EXPECT_EQ(surfaceAtStart(theCase).size(), 0) << is3D;
    }
}

TEST(FreeSurface, IsNotOnNorInABodyUnderWater)
{
    for (const bool is3D : {false, true})
    {
        const CaseDirectory theCase;
        atRest(theCase, is3D);
        theCase.write(
            "constant/tankProperties",
            theCase.text("constant/tankProperties") +
                "geometry { block { type searchableBox; min (-0.06 -0.06 0); max (0.06 0.06 0.07); } }\n"
        );
        const SurfaceRead surface = surfaceAtStart(theCase);
        ASSERT_GT(surface.size(), 20);
        EXPECT_NEAR(surface.box().min().z(), 0.1, 0.015 * dx) << is3D;
        EXPECT_NEAR(surface.box().max().z(), 0.1, 0.015 * dx) << is3D;
    }
}

TEST(FreeSurface, EndsOnABodyThatStandsOutOfTheWater)
{
    // The particles of a body are whole cells, so that its face is not quite where they end.
    for (const auto& [face, share] : {std::pair("0.04", 0.015), {"0.043", 0.15}})
    {
        const CaseDirectory theCase;
        atRest(theCase, false);
        theCase.write(
            "constant/tankProperties", theCase.text("constant/tankProperties") +
                                           "geometry { block { type searchableBox; min (-0.5 -" + face +
                                           " 0); max (0.5 " + face + " 0.15); } }\n"
        );
        const SurfaceRead surface = surfaceAtStart(theCase);
        EXPECT_EQ(surface->GetNumberOfLines(), 2) << face;
        double nearest = 1;
        for (vtkIdType i = 0; i < surface.size(); ++i)
        {
            nearest = std::min(nearest, std::abs(surface.point(i).y()));
            EXPECT_NEAR(surface.point(i).z(), 0.1, share * dx) << face;
        }
        EXPECT_NEAR(nearest, std::stod(face), 1e-3 * dx);
    }
}

/// The tutorial of a disc or a sphere of radius 1 at time 0, of particles at that spacing.
SurfaceRead roundLiquid(const std::string& tutorial, double spacing)
{
    const CaseDirectory theCase;
    for (const std::string folder : {"constant", "system"})
    {
        theCase.remove(folder);
        fs::copy(
            fs::path(SLOSH_SOURCE) / "tutorials/stretchingPatch" / tutorial / folder, theCase.path() / folder,
            fs::copy_options::recursive
        );
    }
    theCase.write(
        "system/blockParticlesDict",
        theCase.text("system/blockParticlesDict") + "particleSpacing " + std::to_string(spacing) + ";\n"
    );
    return surfaceAtStart(theCase);
}

/// Root mean square of the relative errors of the area or the volume at spacings about `spacing`: how a lattice happens
/// to fill a circle must not decide.
double roundError(const std::string& tutorial, double spacing, double exact)
{
    double squares = 0;
    int n = 0;
    for (const double factor : {1.0, 0.97, 0.94, 0.91, 0.88, 0.85, 0.82, 0.79})
    {
        const double error = roundLiquid(tutorial, factor * spacing).enclosed() / exact - 1;
        squares += error * error;
        ++n;
    }
    return std::sqrt(squares / n);
}

TEST(FreeSurface, OfADropEnclosesItsVolumeToSecondOrder)
{
    const double coarse = roundError("drop3D", 0.2, 4 * pi / 3), fine = roundError("drop3D", 0.1, 4 * pi / 3);
    EXPECT_LT(fine, 0.035);
    const double order = std::log2(coarse / fine);
    EXPECT_GT(order, 1.8);
    EXPECT_LT(order, 2.2);
}

TEST(FreeSurface, OfADiscEnclosesItsAreaAsWellAsALatticeFillsIt)
{
    const double coarse = roundError("cao2014", 0.1, pi), fine = roundError("cao2014", 0.025, pi);
    EXPECT_LT(fine, 0.0012);
    // The area of a circle of lattice cells errs by the spacing to the power 3/2.
    const double order = std::log2(coarse / fine) / 2;
    EXPECT_GT(order, 1.4);
    EXPECT_LT(order, 2.0);
}

TEST(FreeSurface, HasPointsInProportionToItsLengthOrAreaOverTheSpacing)
{
    const auto points = [](const std::string& tutorial, double spacing)
    { return static_cast<double>(roundLiquid(tutorial, spacing).size()); };
    EXPECT_NEAR(points("cao2014", 0.025) / points("cao2014", 0.05), 2, 0.1);
    EXPECT_NEAR(points("drop3D", 0.06) / points("drop3D", 0.12), 4, 0.2);
}

TEST(FreeSurface, MovesWithTheTankInTheInertialFrame)
{
    const CaseDirectory theCase;
    theCase.succeed("blockParticles");
    theCase.succeed("sloshSPHFoam");
    theCase.succeed("particlesToVTK -surface -frame tank -latestTime");
    const SurfaceRead inTank(theCase, "0.1");
    theCase.succeed("particlesToVTK -surface -latestTime");
    const SurfaceRead moved(theCase, "0.1");
    TimeState state;
    readTime(Case(theCase.path()), "0.1", state);
    EXPECT_GT(std::abs(state.tank.R(2, 1)), 0.05) << "the tank has turned";
    ASSERT_EQ(moved.size(), inTank.size());
    ASSERT_GT(moved.size(), 20);
    double fastest = 0;
    for (vtkIdType i = 0; i < moved.size(); ++i)
    {
        const Vec X = inTank.point(i);
        EXPECT_LT((moved.point(i) - state.tank.pointToInertial(X)).norm(), 1e-7);
        const Vec carried = state.tank.velocityAt(X) + state.tank.R * inTank.U(i);
        EXPECT_LT((moved.U(i) - carried).norm(), 1e-6);
        EXPECT_NEAR(moved.p(i), inTank.p(i), 1e-3);
        fastest = std::max(fastest, inTank.U(i).norm());
    }
    EXPECT_GT(fastest, 0.01);
}

TEST(FreeSurface, IsWrittenOnlyWhenAskedForAndHasNoTextForm)
{
    const CaseDirectory theCase;
    theCase.succeed("blockParticles");
    const Ended refused = theCase.run("particlesToVTK -surface -format csv");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("-surface has no comma-separated form"), std::string::npos) << refused.err;
    theCase.succeed("particlesToVTK");
    EXPECT_FALSE(fs::exists(theCase.path() / "VTK/surface.vtp.series"));
}

TEST(FreeSurface, HasTheSameBitsAtAnyNumberOfThreads)
{
    const CaseDirectory theCase;
    theCase.succeed("blockParticles");
    theCase.succeed("particlesToVTK -surface -threads 1");
    const std::string one = theCase.text("VTK/surface_0.vtp");
    theCase.succeed("particlesToVTK -surface -threads 3");
    EXPECT_TRUE(theCase.text("VTK/surface_0.vtp") == one);
}

} // namespace
} // namespace slosh
