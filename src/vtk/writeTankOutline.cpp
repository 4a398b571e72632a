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

TankOutline::TankOutline(const Tank& tank, const SolverFrame& frame) : Outline(tank.walls().outline())
{
    for (Vec& corner : corners)
    {
        corner = frame.fromTank(corner);
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
