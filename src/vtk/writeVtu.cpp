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

#include <algorithm>
#include <type_traits>

namespace slosh
{

namespace
{

template <class T>
auto vtkArrayOf(const std::string& name, const std::vector<T>& values, std::ptrdiff_t first, std::ptrdiff_t n)
{
    using Array = std::conditional_t<std::is_same_v<T, int>, vtkIntArray, vtkDoubleArray>;
    return arrayOf<Array>(name, values, first, n);
}

} // namespace

const std::vector<std::string>& usualFields()
{
    static const std::vector<std::string> names{"U", "p", "rho", "origId"};
    return names;
}

std::vector<std::string> fieldNames(const Particles& particles, ParticleRange range)
{
    std::vector<std::string> names;
    particles.forEachField(
        [&](const std::string& name, ParticleRange has, const auto&)
        {
            if (name != "positions" && (has == ParticleRange::all || has == range))
            {
                names.push_back(name);
            }
        }
    );
    return names;
}

std::vector<std::string> fieldNames(const Particles& particles)
{
    std::vector<std::string> names = fieldNames(particles, ParticleRange::liquid);
    const std::vector<std::string> ofWalls = fieldNames(particles, ParticleRange::wall);
    std::copy_if(
        ofWalls.begin(), ofWalls.end(), std::back_inserter(names),
        [&](const std::string& name) { return std::find(names.begin(), names.end(), name) == names.end(); }
    );
    return names;
}

void writeVtu(
    const std::filesystem::path& file, const Particles& particles, ParticleRange range,
    const std::vector<std::string>& fields, double time
)
{
    const std::ptrdiff_t first = particles.first(range), n = particles.size(range);
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

    const std::vector<std::string> present = fieldNames(particles);
    for (const std::string& field : fields)
    {
        if (std::find(present.begin(), present.end(), field) == present.end())
        {
            throw unknownName("field", field, "", present);
        }
        particles.forEachField(
            [&](const std::string& name, ParticleRange has, const auto& values)
            {
                if (name == field && (has == ParticleRange::all || has == range))
                {
                    grid->GetPointData()->AddArray(vtkArrayOf(name, values, first - particles.first(has), n));
                }
            }
        );
    }
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writeXml(file, *writer, *grid, time);
}

} // namespace slosh
