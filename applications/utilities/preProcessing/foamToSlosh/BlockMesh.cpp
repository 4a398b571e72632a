// SPDX-License-Identifier: GPL-3.0-or-later
#include "BlockMesh.hpp"

#include "ListReader.hpp"
#include "Turn.hpp"
#include "decimal.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

/// What cannot be converted, each behind its place.
using Obstacles = std::vector<std::string>;

/// "a curved edge", "the first of 3 curved edges".
std::string firstOf(int count, const std::string& one, const std::string& several)
{
    return count == 1 ? one : "the first of " + std::to_string(count) + " " + several;
}

/// The next point of a list, scaled.
Vec vertexOf(ListReader& list, double scale)
{
    const Vec X = list.vector();
    return scale == 1 ? X : Vec(decimal(scale * X[0]), decimal(scale * X[1]), decimal(scale * X[2]));
}

void readVertices(const Dictionary& dict, double scale, BlockMesh& mesh, Obstacles& obstacles)
{
    ListReader list(dict, "vertices");
    int projected = 0;
    std::string first;
    list.expect('(');
    while (!list.nextIs(')'))
    {
        if (list.nextIs('('))
        {
            mesh.vertices.push_back(vertexOf(list, scale));
            continue;
        }
        const std::string place = list.place();
        const std::string word = list.word();
        if (word != "project")
        {
            throw errorIn(place, "unknown vertex '" + word + "'; expected (x y z), or project (x y z) (surfaces)");
        }
        first = projected++ == 0 ? place : first;
        mesh.vertices.push_back(vertexOf(list, scale));
        list.skip(); // the surfaces
    }
    if (projected > 0)
    {
        obstacles.push_back(
            first + ": " + firstOf(projected, "a vertex", "vertices") + " projected on surfaces by 'vertices'"
        );
    }
}

/// A list of `kind label label geometry`. A straight edge is none.
void readEdges(const Dictionary& dict, Obstacles& obstacles)
{
    if (!dict.has("edges"))
    {
        return;
    }
    ListReader list(dict, "edges");
    list.expect('(');
    std::string kinds, first;
    int count = 0;
    while (!list.nextIs(')'))
    {
        const std::string place = list.place(), kind = list.word();
        while (!list.nextIs(')') && !list.nextIsWord())
        {
            list.skip();
        }
        if (kind == "line")
        {
            continue;
        }
        first = count++ == 0 ? place : first;
        if ((kinds + " ").find(" " + kind + " ") == std::string::npos)
        {
            kinds += " " + kind;
        }
    }
    if (count > 0)
    {
        obstacles.push_back(
            first + ": " + firstOf(count, "a curved edge", "curved edges") + " (" + kinds.substr(1) + ")"
        );
    }
}

void readBlocks(const Dictionary& dict, BlockMesh& mesh)
{
    ListReader list(dict, "blocks");
    list.expect('(');
    while (!list.nextIs(')'))
    {
        const std::string place = list.place();
        const std::string shape = list.word();
        if (shape != "hex")
        {
            throw errorIn(place, "unknown block '" + shape + "'; expected hex");
        }
        const std::vector<int> corners = list.labels();
        const bool known = std::all_of(
            corners.begin(), corners.end(), [&](int label) { return label >= 0 && label < std::ssize(mesh.vertices); }
        );
        if (corners.size() != 8 || !known)
        {
            throw errorIn(
                place, "the vertices of the block are wrong; expected 8 labels from 0 to " +
                           std::to_string(std::ssize(mesh.vertices) - 1)
            );
        }
        std::copy(corners.begin(), corners.end(), mesh.blocks.emplace_back().begin());
        mesh.zones.push_back(list.nextIsWord() && !list.nextIsWord("hex") ? list.word() : "");
        // Cells and grading.
        while (!list.nextIs(')') && !list.nextIsWord("hex"))
        {
            list.skip();
        }
    }
    if (mesh.blocks.empty())
    {
        throw dict.errorAt("blocks", "is empty; expected hex (8 labels) ...");
    }
}

std::vector<BlockMesh::Face> readFaces(ListReader& list, const BlockMesh& mesh)
{
    std::vector<BlockMesh::Face> faces;
    list.expect('(');
    while (!list.nextIs(')'))
    {
        const std::string place = list.place();
        BlockMesh::Face face = list.labels();
        if (face.size() == 2 && face[0] >= 0 && face[0] < std::ssize(mesh.blocks) && face[1] >= 0 && face[1] < 6)
        {
            face = BlockMesh::facesOf(mesh.blocks[face[0]])[face[1]];
        }
        if (face.size() < 3)
        {
            throw errorIn(
                place,
                "the face has fewer than 3 corners; expected their labels, or those of a block and of one of its "
                "six faces"
            );
        }
        faces.push_back(std::move(face));
    }
    list.expect(')');
    return faces;
}

void readPatches(const Dictionary& dict, BlockMesh& mesh)
{
    if (dict.has("boundary"))
    {
        ListReader list(dict, "boundary");
        list.expect('(');
        while (!list.nextIs(')'))
        {
            const std::string place = list.place(), name = list.word();
            const Dictionary patch = list.dictionary(name);
            ListReader faces(patch, "faces");
            mesh.patches.push_back({name, patch.word("type"), readFaces(faces, mesh), place});
        }
    }
    else if (dict.has("patches"))
    {
        ListReader list(dict, "patches");
        list.expect('(');
        while (!list.nextIs(')'))
        {
            const std::string place = list.place(), type = list.word(), name = list.word();
            mesh.patches.push_back({name, type, readFaces(list, mesh), place});
        }
    }
    const Dictionary defaults = dict.dictOr("defaultPatch");
    mesh.defaultName = defaults.wordOr("name", mesh.defaultName);
    mesh.defaultType = defaults.wordOr("type", mesh.defaultType);
}

} // namespace

std::vector<BlockMesh::Face> BlockMesh::facesOf(const std::array<int, 8>& b)
{
    return {{b[0], b[4], b[7], b[3]}, {b[1], b[2], b[6], b[5]}, {b[0], b[1], b[5], b[4]},
            {b[3], b[7], b[6], b[2]}, {b[0], b[3], b[2], b[1]}, {b[4], b[5], b[6], b[7]}};
}

BlockMesh BlockMesh::read(const Dictionary& dict)
{
    BlockMesh mesh;
    mesh.file = dict.name();
    const double scale =
        dict.scalarOr("scale", dict.scalarOr("convertToMeters", 1, unit::none, positive), unit::none, positive);
    Obstacles obstacles;
    readVertices(dict, scale, mesh, obstacles);
    readEdges(dict, obstacles);
    for (const auto& [key, what] :
         {std::pair<std::string, std::string>("faces", "faces projected on surfaces by"),
          {"mergePatchPairs", "blocks joined by"}})
    {
        if (dict.has(key) && dict.tokens(key).size() > 2)
        {
            obstacles.push_back(dict.placeOf(key) + ": " + what + " '" + key + "'");
        }
    }
    for (const auto* key : {"prescale", "transform"})
    {
        if (dict.has(key))
        {
            obstacles.push_back(dict.placeOf(key) + ": vertices moved by '" + key + "'");
        }
    }
    if (!obstacles.empty())
    {
        std::string message = "the tank cannot be converted; expected straight edges between given vertices. Found";
        for (const auto& obstacle : obstacles)
        {
            message += "\n    " + obstacle;
        }
        throw errorIn(dict.name(), message);
    }
    readBlocks(dict, mesh);
    readPatches(dict, mesh);
    return mesh;
}

BlockMesh BlockMesh::turned(const Turn& turn) const
{
    BlockMesh mesh = *this;
    for (Vec& X : mesh.vertices)
    {
        X = turn(X);
    }
    return mesh;
}

} // namespace slosh
