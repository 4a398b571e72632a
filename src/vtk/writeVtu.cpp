#include "vtk/writeVtu.hpp"

#include "base/CaseError.hpp"
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

namespace
{

/// values[first], ..., values[first + n - 1] as an array with the components of one value.
template <class Array, class T>
vtkNew<Array> arrayOf(const std::string& name, const std::vector<T>& values, std::ptrdiff_t first, std::ptrdiff_t n)
{
    vtkNew<Array> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(std::is_same_v<T, Vec> ? 3 : 1);
    array->SetNumberOfTuples(n);
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        const T& value = values[static_cast<std::size_t>(first + i)];
        if constexpr (std::is_same_v<T, Vec>)
        {
            array->SetTuple3(i, value.x(), value.y(), value.z());
        }
        else
        {
            array->SetValue(i, value);
        }
    }
    return array;
}

} // namespace

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
