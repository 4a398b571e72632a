// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/polyMesh.hpp"

#include "base/writeFile.hpp"
#include "case/foamFile.hpp"

#include <sstream>

namespace slosh
{

void writePolyMesh(const Case& theCase, const BoundingBox& box)
{
    const std::string location = "constant/polyMesh";
    const auto write = [&](const std::string& object, const std::string& className, const std::string& content)
    { writeFile(theCase.root() / location / object, foamHeader(className, location, object) + "\n" + content); };

    std::ostringstream points;
    points.precision(10);
    points << "8\n(\n";
    for (int corner = 0; corner < 8; ++corner)
    {
        const Vec x(
            (corner & 1) != 0 ? box.max().x() : box.min().x(), (corner & 2) != 0 ? box.max().y() : box.min().y(),
            (corner & 4) != 0 ? box.max().z() : box.min().z()
        );
        points << "(" << x[0] << " " << x[1] << " " << x[2] << ")\n";
    }
    points << ")\n";
    write("points", "vectorField", points.str());
    // Corner number = x + 2 y + 4 z; each face's normal points outwards.
    write("faces", "faceList", "6\n(\n4(0 4 6 2)\n4(1 3 7 5)\n4(0 1 5 4)\n4(2 6 7 3)\n4(0 2 3 1)\n4(4 5 7 6)\n)\n");
    write("owner", "labelList", "6\n(\n0\n0\n0\n0\n0\n0\n)\n");
    write("neighbour", "labelList", "0\n(\n)\n");
    write(
        "boundary", "polyBoundaryMesh",
        "1\n(\n    walls\n    {\n        type            wall;\n        nFaces          6;\n        startFace       "
        "0;\n    "
        "}\n)\n"
    );
}

void writeMinimalFvFiles(const Case& theCase)
{
    const auto writeMissing = [&](const std::string& object, const std::string& content)
    {
        const auto file = theCase.root() / "system" / object;
        if (!std::filesystem::exists(file))
        {
            writeFile(file, foamHeader("dictionary", "system", object) + content);
        }
    };
    writeMissing(
        "fvSchemes",
        "\n// For OpenFOAM's own tools only; SloshSPH reads system/sphSchemes.\nddtSchemes {}\ngradSchemes {}\n"
        "divSchemes {}\nlaplacianSchemes {}\ninterpolationSchemes {}\nsnGradSchemes {}\n"
    );
    writeMissing("fvSolution", "\n// For OpenFOAM's own tools only; SloshSPH reads system/sphSchemes.\n");
}

} // namespace slosh
