// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/writeVtu.hpp"

#include "base/CaseError.hpp"
#include "vtk/arrayOf.hpp"
#include "vtk/writeXml.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace slosh
{

const std::vector<std::string>& vtuFieldNames()
{
    static const std::vector<std::string> names{"U", "p", "rho", "origId"};
    return names;
}

void writeVtu(const std::filesystem::path& file, const Particles& particles, std::ptrdiff_t first, std::ptrdiff_t n,
              const std::vector<std::string>& fields, double time, const DerivedFields& derived)
{
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf<vtkDoubleArray>("Points", particles.r, first, n));
    vtkNew<vtkCellArray> vertices;
    vertices->AllocateExact(n, n);
    for (vtkIdType i = 0; i < n; ++i)
    {
        vertices->InsertNextCell(1, &i);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->SetCells(VTK_VERTEX, vertices);

    for (const std::string& field : fields)
    {
        if (field == "U")
        {
            grid->GetPointData()->AddArray(arrayOf<vtkDoubleArray>(field, particles.v, first, n));
        }
        else if (field == "p")
        {
            grid->GetPointData()->AddArray(arrayOf<vtkDoubleArray>(field, particles.p, first, n));
        }
        else if (field == "rho")
        {
            grid->GetPointData()->AddArray(arrayOf<vtkDoubleArray>(field, particles.rho, first, n));
        }
        else if (field == "origId")
        {
            grid->GetPointData()->AddArray(arrayOf<vtkIntArray>(field, particles.id, first, n));
        }
        else if (const auto values = derived.find(field); values != derived.end())
        {
            grid->GetPointData()->AddArray(arrayOf<vtkDoubleArray>(field, values->second, first, n));
        }
        else
        {
            throw unknownName("field", field, "", vtuFieldNames());
        }
    }
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writeXml(file, *writer, *grid, time);
}

} // namespace slosh
