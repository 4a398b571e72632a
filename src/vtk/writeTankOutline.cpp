#include "vtk/writeTankOutline.hpp"

#include "vtk/writeXml.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace slosh
{

TankOutline::TankOutline(const Tank& tank, const RigidState& state, Frame frame)
{
    const BoundingBox& box = tank.box();
    const std::vector<int>& directions = tank.directions();
    // Corner number i is at the upper end of direction d where bit d of i is set; an edge joins two that differ in one
    // bit.
    const int n = 1 << directions.size();
    for (int i = 0; i < n; ++i)
    {
        Vec X = box.center();
        for (std::size_t d = 0; d < directions.size(); ++d)
        {
            const int bit = 1 << d;
            X[directions[d]] = (i & bit) ? box.max()[directions[d]] : box.min()[directions[d]];
            if (!(i & bit))
            {
                edges.emplace_back(i, i | bit);
            }
        }
        corners.push_back(frame == Frame::inertial ? state.pointToInertial(X) : X);
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
