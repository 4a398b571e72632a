// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/writeSurface.hpp"

#include "vtk/arrayOf.hpp"
#include "vtk/writeXml.hpp"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace slosh
{

void writeSurface(const std::filesystem::path& file, const Surface& surface, const SurfaceFields& fields, double time)
{
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf<vtkDoubleArray>("Points", surface.points));
    vtkNew<vtkCellArray> cells;
    for (const auto& cell : surface.cells)
    {
        cells->InsertNextCell(static_cast<vtkIdType>(cell.size()));
        for (const std::ptrdiff_t point : cell)
        {
            cells->InsertCellPoint(point);
        }
    }
    vtkNew<vtkPolyData> poly;
    poly->SetPoints(points);
    const bool isPlane = surface.normals.empty();
    isPlane ? poly->SetLines(cells) : poly->SetPolys(cells);
    poly->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("U", fields.U));
    poly->GetPointData()->AddArray(arrayOf<vtkDoubleArray>("p", fields.p));
    if (!isPlane)
    {
        poly->GetPointData()->SetNormals(arrayOf<vtkDoubleArray>("Normals", surface.normals));
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    writeXml(file, *writer, *poly, time);
}

} // namespace slosh
