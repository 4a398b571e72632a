// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of fields whose level sets are known, and their files.
#include "vtk/writeSurface.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <unistd.h>

namespace slosh
{
namespace
{

/// f at the points of a lattice of n intervals over [-1, 1] in each direction but `empty`.
template <class F>
LatticeField sampled(int n, const F& f, int empty = -1)
{
    LatticeField field{Vec(-1, -1, -1), Vec::Constant(2.0 / n), {n + 1, n + 1, n + 1}, {}};
    if (empty >= 0)
    {
        field.origin[empty] = 0;
        field.points[empty] = 1;
    }
    const std::ptrdiff_t size = std::ptrdiff_t{field.points[0]} * field.points[1] * field.points[2];
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
        field.values.push_back(static_cast<float>(f(field.point(i))));
    }
    return field;
}

double everywhere(const Vec&)
{
    return 1;
}

/// Of a closed surface, positive where its triangles turn counter-clockwise seen from outside.
double volumeIn(const Surface& surface)
{
    double volume = 0;
    for (const auto& cell : surface.cells)
    {
        EXPECT_EQ(cell.size(), 3u);
        const auto x = [&](std::size_t k) { return surface.points[cell[k]]; };
        volume += x(0).dot(x(1).cross(x(2))) / 6;
    }
    return volume;
}

constexpr double R = 0.7;

Surface sphere(int n)
{
    return isoSurface(sampled(n, [](const Vec& x) { return 1 - x.norm(); }), 1 - R, everywhere);
}

TEST(IsoSurface, OfASphereEnclosesItsVolumeToSecondOrder)
{
    const double exact = 4 * std::numbers::pi / 3 * R * R * R;
    const double coarse = exact - volumeIn(sphere(20)), fine = exact - volumeIn(sphere(40));
    EXPECT_LT(coarse, 0.015 * exact);
    const double order = std::log2(coarse / fine);
    EXPECT_GT(order, 1.8);
    EXPECT_LT(order, 2.2);
}

TEST(IsoSurface, HasNormalsOfUnitLengthToWhereTheFieldIsLess)
{
    const Surface surface = sphere(40);
    ASSERT_EQ(surface.normals.size(), surface.points.size());
    for (std::size_t i = 0; i < surface.points.size(); ++i)
    {
        EXPECT_NEAR(surface.normals[i].norm(), 1, 1e-6);
        EXPECT_NEAR(surface.normals[i].dot(surface.points[i].normalized()), 1, 1e-4);
    }
}

TEST(IsoSurface, HasFourTimesThePointsOnALatticeTwiceAsFine)
{
    const double ratio = static_cast<double>(sphere(80).points.size()) / static_cast<double>(sphere(40).points.size());
    EXPECT_NEAR(ratio, 4, 0.1);
}

TEST(IsoSurface, OfALinearFieldIsItsPlaneToTheEndOfTheLattice)
{
    const Surface surface = isoSurface(sampled(10, [](const Vec& x) { return x.x() + 2 * x.z(); }), 0.3, everywhere);
    ASSERT_GT(surface.points.size(), 100u);
    double least = 0, most = 0;
    for (const Vec& x : surface.points)
    {
        EXPECT_NEAR(x.x() + 2 * x.z(), 0.3, 1e-6);
        least = std::min(least, x.y());
        most = std::max(most, x.y());
    }
    EXPECT_EQ(least, -1);
    EXPECT_EQ(most, 1);
}

TEST(IsoSurface, InAPlaneIsOneLineFromEndToEnd)
{
    for (const int empty : {0, 1})
    {
        const int along = 1 - empty;
        const Surface surface = isoSurface(
            sampled(
                10, [&](const Vec& x) { return -x.z() + 0.5 * x[along]; }, empty
            ),
            0.13, everywhere
        );
        ASSERT_EQ(surface.cells.size(), 1u) << empty;
        EXPECT_TRUE(surface.normals.empty());
        const auto& line = surface.cells[0];
        const Vec &from = surface.points[line.front()], &to = surface.points[line.back()];
        EXPECT_EQ(std::abs(from[along]), 1);
        EXPECT_EQ(from[along], -to[along]);
        EXPECT_NEAR(from.z(), 0.5 * from[along] - 0.13, 1e-6);
        for (const Vec& x : surface.points)
        {
            EXPECT_EQ(x[empty], 0);
        }
    }
}

TEST(IsoSurface, OfADiscIsOneLineThatCloses)
{
    const Surface surface = isoSurface(
        sampled(
            20, [](const Vec& x) { return 1 - x.norm(); }, 1
        ),
        1 - R, everywhere
    );
    ASSERT_EQ(surface.cells.size(), 1u);
    EXPECT_EQ(surface.cells[0].front(), surface.cells[0].back());
    EXPECT_EQ(surface.cells[0].size(), surface.points.size() + 1);
}

TEST(IsoSurface, IsCutOffWhereItShallNotBe)
{
    const auto field = [](const Vec& x) { return -x.z(); };
    const auto inside = [](const Vec& x) { return 0.33 - x.x(); };
    for (const int empty : {-1, 1})
    {
        const Surface surface = isoSurface(sampled(10, field, empty), -0.05, inside);
        double most = -1;
        for (const Vec& x : surface.points)
        {
            most = std::max(most, x.x());
            EXPECT_NEAR(x.z(), 0.05, 1e-6);
        }
        EXPECT_NEAR(most, 0.33, 1e-6);
    }
}

TEST(IsoSurface, OfALatticeWithoutPointsHasNone)
{
    EXPECT_TRUE(isoSurface({}, 0.5, everywhere).points.empty());
}

TEST(SurfaceFile, IsReadBackByVtkWithTheSameBits)
{
    const auto file = std::filesystem::temp_directory_path() / ("surface" + std::to_string(getpid()) + ".vtp");
    const auto linear = [](const Vec& x) { return x.x() + 2 * x.z(); };
    for (const int empty : {-1, 1})
    {
        const Surface surface = isoSurface(sampled(10, linear, empty), 0.3, everywhere);
        SurfaceFields fields;
        for (const Vec& x : surface.points)
        {
            fields.U.push_back(x / 3);
            fields.p.push_back(x.x() / 7);
        }
        writeSurface(file, surface, fields, 1.0 / 3);
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(file.c_str());
        reader->Update();
        vtkPolyData* poly = reader->GetOutput();
        ASSERT_EQ(poly->GetNumberOfPoints(), static_cast<vtkIdType>(surface.points.size()));
        const auto cells = static_cast<vtkIdType>(surface.cells.size());
        EXPECT_EQ(poly->GetNumberOfLines(), empty < 0 ? 0 : cells);
        EXPECT_EQ(poly->GetNumberOfPolys(), empty < 0 ? cells : 0);
        EXPECT_EQ(poly->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 1.0 / 3);
        vtkDataArray *U = poly->GetPointData()->GetArray("U"), *p = poly->GetPointData()->GetArray("p"),
                     *normals = poly->GetPointData()->GetNormals();
        EXPECT_EQ(normals != nullptr, empty < 0);
        for (vtkIdType i = 0; i < poly->GetNumberOfPoints(); ++i)
        {
            const auto k = static_cast<std::size_t>(i);
            EXPECT_EQ(Vec(poly->GetPoint(i)), surface.points[k]);
            EXPECT_EQ(Vec(U->GetTuple3(i)), fields.U[k]);
            EXPECT_EQ(p->GetTuple1(i), fields.p[k]);
            if (normals != nullptr)
            {
                EXPECT_EQ(Vec(normals->GetTuple3(i)), surface.normals[k]);
            }
        }
        for (vtkIdType c = 0; c < cells; ++c)
        {
            const auto& cell = surface.cells[c];
            ASSERT_EQ(poly->GetCell(c)->GetNumberOfPoints(), static_cast<vtkIdType>(cell.size()));
            for (std::size_t k = 0; k < cell.size(); ++k)
            {
                EXPECT_EQ(poly->GetCell(c)->GetPointId(static_cast<vtkIdType>(k)), cell[k]);
            }
        }
    }
    std::filesystem::remove(file);
}

} // namespace
} // namespace slosh
