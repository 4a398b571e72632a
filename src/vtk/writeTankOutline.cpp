// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/writeTankOutline.hpp"

#include "vtk/writeXml.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace slosh
{

namespace
{

Prism prismOf(const Tank& box)
{
    const int along = box.emptyDirection() < 0 ? 2 : box.emptyDirection();
    const std::array<int, 2> axes = {along == 0 ? 1 : 0, along == 2 ? 1 : 2};
    const Vec low = box.box().min(), high = box.box().max();
    const int a = axes[0], b = axes[1];
    return {Polygon({{low[a], low[b]}, {high[a], low[b]}, {high[a], high[b]}, {low[a], high[b]}}), axes, low[along],
            high[along], box.dim() == 2};
}

} // namespace

TankOutline::TankOutline(const Tank& tank, const SolverFrame& frame)
{
    // A box, too, is a prism: upright in 3D.
    const Prism walls = tank.prism() ? *tank.prism() : prismOf(tank);
    const int n = static_cast<int>(walls.section().corners().size());
    const int along = walls.along();
    const bool isSlice = along == tank.emptyDirection();
    const Vec low = tank.box().min(), high = tank.box().max(), middle = tank.box().center();
    for (const double at : isSlice ? std::vector{middle[along]} : std::vector{low[along], high[along]})
    {
        const int first = static_cast<int>(corners.size());
        for (int i = 0; i < n; ++i)
        {
            const Vec X = walls.point(walls.section().corner(i), at);
            corners.push_back(frame.fromTank(X));
            edges.emplace_back(first + i, first + (i + 1) % n);
            if (first > 0)
            {
                edges.emplace_back(i, first + i);
            }
        }
    }
}

void writeTankOutline(const std::filesystem::path& file, const TankOutline& outline, double time)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec& x : outline.corners)
    {
        points->InsertNextPoint(x.data());
    }
    vtkNew<vtkCellArray> lines;
    for (const auto& [from, to] : outline.edges)
    {
        const vtkIdType ends[] = {from, to};
        lines->InsertNextCell(2, ends);
    }
    vtkNew<vtkPolyData> poly;
    poly->SetPoints(points);
    poly->SetLines(lines);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writeXml(file, *writer, *poly, time);
}

} // namespace slosh
