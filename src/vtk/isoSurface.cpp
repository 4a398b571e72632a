// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/isoSurface.hpp"

#include <vtkCellArrayIterator.h>
#include <vtkClipPolyData.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>

#include <algorithm>

namespace slosh
{

namespace
{

vtkNew<vtkImageData> imageOf(const LatticeField& field)
{
    vtkNew<vtkImageData> image;
    image->SetOrigin(field.origin.data());
    image->SetSpacing(field.step.data());
    image->SetDimensions(field.points.data());
    vtkNew<vtkFloatArray> values;
    // VTK only reads, and leaves the memory to its owner.
    values->SetArray(const_cast<float*>(field.values.data()), static_cast<vtkIdType>(field.values.size()), 1);
    image->GetPointData()->SetScalars(values);
    return image;
}

vtkNew<vtkPolyData> contour(const LatticeField& field, double value)
{
    vtkNew<vtkContourFilter> filter;
    filter->SetInputData(imageOf(field));
    filter->SetValue(0, value);
    filter->ComputeNormalsOn();
    filter->ComputeScalarsOff();
    filter->Update();
    vtkNew<vtkPolyData> surface;
    surface->ShallowCopy(filter->GetOutput());
    return surface;
}

/// The part of `surface` with inside(X) >= 0, as cells of the kind a Surface holds.
vtkNew<vtkPolyData> clipped(vtkPolyData& surface, const std::function<double(const Vec&)>& inside, bool isPlane)
{
    vtkNew<vtkDoubleArray> depth;
    depth->SetNumberOfTuples(surface.GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i)
    {
        depth->SetValue(i, inside(Vec(surface.GetPoint(i))));
    }
    surface.GetPointData()->SetScalars(depth);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(&surface);
    vtkNew<vtkStripper> join;
    join->SetInputConnection(clip->GetOutputPort());
    join->JoinContiguousSegmentsOn();
    join->SetMaximumLength(static_cast<int>(surface.GetNumberOfCells()) + 1);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(clip->GetOutputPort());
    vtkPolyDataAlgorithm& last = isPlane ? static_cast<vtkPolyDataAlgorithm&>(*join) : *triangles;
    last.Update();
    vtkNew<vtkPolyData> part;
    part->ShallowCopy(last.GetOutput());
    return part;
}

} // namespace

Surface isoSurface(const LatticeField& field, double value, const std::function<double(const Vec&)>& inside)
{
    Surface surface;
    if (field.values.empty())
    {
        return surface;
    }
    const bool isPlane = *std::min_element(field.points.begin(), field.points.end()) == 1;
    const vtkNew<vtkPolyData> part = clipped(*contour(field, value), inside, isPlane);
    vtkDataArray* normals = isPlane ? nullptr : part->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
        surface.points.emplace_back(part->GetPoint(i));
        if (normals != nullptr)
        {
            surface.normals.push_back(Vec(normals->GetTuple3(i)).normalized());
        }
    }
    vtkCellArray* cells = isPlane ? part->GetLines() : part->GetPolys();
    const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
        vtkIdType n = 0;
        const vtkIdType* ids = nullptr;
        cell->GetCurrentCell(n, ids);
        surface.cells.emplace_back(ids, ids + n);
    }
    return surface;
}

} // namespace slosh
