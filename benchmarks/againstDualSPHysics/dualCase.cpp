// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the particles that blockParticles has made as a case of DualSPHysics (in place of its GenCase), and compares
// the particles of both programs after a run. Allrun compiles it with DualSPHysics' own classes for its files.
//     dualCase write <our case> <file of constants> <name>      name.bi4, name.xml; the liquid's number is printed
//     dualCase compare <our case> <file of constants> <file of particles>      fails where the flows differ
// Constants: lines "name value", as Allrun writes them.
#include "JPartDataBi4.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using Vec = std::array<double, 3>;
using Constants = std::map<std::string, double>;

struct Block
{
    std::vector<Vec> r, v;
    std::vector<double> p;
    std::vector<int> id;
};

/// A list of our binary files: `stride` bytes an element, of which those from `skip` on are kept.
template <class T>
std::vector<T> readList(const std::filesystem::path& path, std::size_t stride = sizeof(T), std::size_t skip = 0)
{
    std::ifstream in(path, std::ios::binary);
    const std::string all((std::istreambuf_iterator<char>(in)), {});
    const std::size_t header = all.find("}\n");
    if (header == std::string::npos || all.find("binary;") > header)
    {
        throw std::runtime_error(path.string() + ": no binary list");
    }
    std::size_t digits = 0;
    const std::size_t n = std::stoul(all.substr(header + 1, 40), &digits);
    const std::size_t begin = all.find('(', header + 1 + digits) + 1;
    if (begin + n * stride > all.size())
    {
        throw std::runtime_error(path.string() + ": too short");
    }
    std::vector<T> list(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        std::memcpy(&list[i], &all[begin + i * stride + skip], sizeof(T));
    }
    return list;
}

/// Liquid or walls at a time, by the number each particle was made with.
Block readBlock(const std::filesystem::path& folder)
{
    // A position: end of line, bracket, three numbers, the label of a cell, bracket.
    const Block found{
        readList<Vec>(folder / "positions", 2 + 24 + 4 + 1, 2), readList<Vec>(folder / "U"),
        readList<double>(folder / "p"), readList<int>(folder / "origId")};
    const std::size_t n = found.r.size();
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        order[i] = i;
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return found.id[a] < found.id[b]; });
    Block sorted;
    for (const std::size_t i : order)
    {
        sorted.r.push_back(found.r[i]);
        sorted.v.push_back(found.v[i]);
        sorted.p.push_back(found.p[i]);
        sorted.id.push_back(found.id[i]);
    }
    return sorted;
}

Constants readConstants(const std::string& path)
{
    std::ifstream in(path);
    Constants constants;
    std::string name;
    for (double value = 0; in >> name >> value;)
    {
        constants[name] = value;
    }
    return constants;
}

double stiffness(const Constants& c)
{
    return c.at("rho0") * c.at("c0") * c.at("c0") / c.at("gamma");
}

void writeXml(const std::string& path, const Constants& c, std::size_t nWall, std::size_t nLiquid)
{
    std::ofstream out(path);
    out.precision(12);
    const auto value = [&](const std::string& name, auto v)
    { out << "      <" << name << " value=\"" << v << "\" />\n"; };
    const auto parameter = [&](const std::string& key, auto v)
    { out << "      <parameter key=\"" << key << "\" value=\"" << v << "\" />\n"; };

    out << "<case app=\"dualCase\">\n  <execution>\n    <constants>\n";
    value("data2d", c.at("dimensions") == 2 ? "true" : "false");
    value("data2dposy", 0);
    out << "      <gravity x=\"0\" y=\"0\" z=\"" << -c.at("g") << "\" />\n";
    value("cflnumber", 0.2); // of no effect: the step is DtFixed
    value("gamma", c.at("gamma"));
    value("rhop0", c.at("rho0"));
    value("dp", c.at("dx"));
    value("h", c.at("h"));
    value("b", stiffness(c));
    value("massbound", c.at("mass"));
    value("massfluid", c.at("mass"));
    out << "    </constants>\n    <particles np=\"" << nWall + nLiquid << "\" nb=\"" << nWall << "\" nbf=\"" << nWall
        << "\" mkboundfirst=\"11\" mkfluidfirst=\"1\">\n"
        << "      <fixed mkbound=\"0\" mk=\"11\" begin=\"0\" count=\"" << nWall << "\" />\n"
        << "      <fluid mkfluid=\"0\" mk=\"1\" begin=\"" << nWall << "\" count=\"" << nLiquid << "\" />\n"
        << "    </particles>\n    <parameters>\n";
    const double end = (c.at("steps") - 0.5) * c.at("dt");  // it stops at the end of the step that reaches this
    parameter("Boundary", 1);                               // dynamic boundary particles
    parameter("StepAlgorithm", c.at("evaluationsPerStep")); // 1 Verlet, 2 symplectic
    parameter("Kernel", 2);                                 // Wendland
    parameter("ViscoTreatment", 1);                         // artificial
    parameter("Visco", c.at("alpha"));
    parameter("ViscoBoundFactor", 1);
    parameter("DensityDT", c.at("delta") > 0 ? 2 : 0); // Fourtakas et al. 2019
    parameter("DensityDTvalue", c.at("delta"));
    parameter("DtFixed", c.at("dt"));
    parameter("DtIni", c.at("dt"));
    parameter("TimeMax", end);
    parameter("TimeOut", end);
    out << "    </parameters>\n  </execution>\n</case>\n";
}

void write(const std::filesystem::path& ours, const std::string& name, const Constants& c)
{
    const Block wall = readBlock(ours / "0/lagrangian/wall"), liquid = readBlock(ours / "0/lagrangian/fluid");
    const std::size_t nWall = wall.r.size(), nLiquid = liquid.r.size(), n = nWall + nLiquid;
    std::vector<unsigned> id(n);
    std::vector<tdouble3> r(n);
    std::vector<tfloat3> v(n);
    std::vector<float> rho(n);
    tdouble3 lowest = TDouble3(1e9), highest = TDouble3(-1e9);
    for (std::size_t i = 0; i < n; ++i)
    {
        const Block& block = i < nWall ? wall : liquid;
        const std::size_t k = i < nWall ? i : i - nWall;
        id[i] = static_cast<unsigned>(i);
        r[i] = TDouble3(block.r[k][0], block.r[k][1], block.r[k][2]);
        v[i] = TFloat3(
            static_cast<float>(block.v[k][0]), static_cast<float>(block.v[k][1]), static_cast<float>(block.v[k][2])
        );
        rho[i] = static_cast<float>(c.at("rho0") * std::pow(1 + block.p[k] / stiffness(c), 1 / c.at("gamma")));
        lowest = TDouble3(std::min(lowest.x, r[i].x), std::min(lowest.y, r[i].y), std::min(lowest.z, r[i].z));
        highest = TDouble3(std::max(highest.x, r[i].x), std::max(highest.y, r[i].y), std::max(highest.z, r[i].z));
    }

    const std::filesystem::path path(name);
    const auto count = static_cast<unsigned>(n);
    JPartDataBi4 file;
    file.ConfigBasic(
        0, 1, "", "dualCase", path.filename().string(), c.at("dimensions") == 2, 0, path.parent_path().string()
    );
    file.ConfigParticles(n, nWall, 0, 0, nLiquid, lowest, highest);
    file.ConfigCtes(c.at("dx"), c.at("h"), stiffness(c), c.at("rho0"), c.at("gamma"), c.at("mass"), c.at("mass"));
    file.AddPartInfo(0, 0, count, 0, 0, 0, lowest, highest);
    file.AddPartData(count, id.data(), r.data(), v.data(), rho.data());
    file.SaveFileCase(path.filename().string());
    writeXml(name + ".xml", c, nWall, nLiquid);
    std::cout << nLiquid << "\n";
}

/// Mean number of particles, of the liquid and the walls, within 2h of one of the liquid.
double neighbours(const std::vector<Vec>& liquid, const std::vector<Vec>& wall, double h)
{
    using Cell = std::array<int, 3>;
    const auto cellOf = [&](const Vec& r)
    {
        return Cell{
            static_cast<int>(std::floor(r[0] / (2 * h))), static_cast<int>(std::floor(r[1] / (2 * h))),
            static_cast<int>(std::floor(r[2] / (2 * h)))};
    };
    std::map<Cell, std::vector<Vec>> cells;
    for (const auto* list : {&liquid, &wall})
    {
        for (const Vec& r : *list)
        {
            cells[cellOf(r)].push_back(r);
        }
    }
    std::size_t pairs = 0;
    for (const Vec& a : liquid)
    {
        const Cell at = cellOf(a);
        for (int k = 0; k < 27; ++k)
        {
            const auto cell = cells.find({at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1});
            if (cell == cells.end())
            {
                continue;
            }
            for (const Vec& b : cell->second)
            {
                pairs += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 2 * h ? 1 : 0;
            }
        }
    }
    return static_cast<double>(pairs) / static_cast<double>(liquid.size()) - 1; // but itself
}

double kinetic(const Block& block)
{
    double sum = 0;
    for (const Vec& v : block.v)
    {
        sum += v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    }
    return sum;
}

double highestPressure(const Block& block)
{
    return *std::max_element(block.p.begin(), block.p.end());
}

/// Where DualSPHysics has brought the liquid.
Block readTheirs(const std::string& path, const Constants& c, std::size_t nWall)
{
    JPartDataBi4 file;
    file.LoadFilename(path);
    const unsigned n = file.Get_Npok();
    std::vector<unsigned> id(n);
    std::vector<tfloat3> r(n), v(n);
    std::vector<float> rho(n);
    file.Get_Idp(n, id.data());
    file.Get_Pos(n, r.data());
    file.Get_Vel(n, v.data());
    file.Get_Rhop(n, rho.data());
    Block liquid;
    liquid.r.resize(n - nWall);
    liquid.v.resize(n - nWall);
    liquid.p.resize(n - nWall);
    for (unsigned i = 0; i < n; ++i)
    {
        if (id[i] >= nWall)
        {
            const std::size_t k = id[i] - nWall;
            liquid.r.at(k) = {r[i].x, r[i].y, r[i].z};
            liquid.v.at(k) = {v[i].x, v[i].y, v[i].z};
            liquid.p.at(k) = stiffness(c) * (std::pow(rho[i] / c.at("rho0"), c.at("gamma")) - 1);
        }
    }
    return liquid;
}

std::filesystem::path latestTime(const std::filesystem::path& ours)
{
    double latest = 0;
    std::filesystem::path found;
    for (const auto& item : std::filesystem::directory_iterator(ours))
    {
        char* end = nullptr;
        const std::string name = item.path().filename().string();
        const double time = std::strtod(name.c_str(), &end);
        if (*end == 0 && time > latest)
        {
            latest = time;
            found = item.path();
        }
    }
    if (found.empty())
    {
        throw std::runtime_error(ours.string() + ": no time beside 0");
    }
    return found;
}

/// Fails where one of the programs has not computed the same flow.
bool compare(const std::filesystem::path& ours, const Constants& c, const std::string& theirs)
{
    const Block wall = readBlock(ours / "0/lagrangian/wall"), start = readBlock(ours / "0/lagrangian/fluid");
    const Block one = readTheirs(theirs, c, wall.r.size());
    const Block other = readBlock(latestTime(ours) / "lagrangian/fluid");
    const std::size_t n = start.r.size();
    if (one.r.size() != n || other.r.size() != n)
    {
        std::cerr << "Particles were lost\n";
        return false;
    }
    double moved = 0, apart = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        for (int d = 0; d < 3; ++d)
        {
            moved += std::pow(other.r[i][d] - start.r[i][d], 2);
            apart += std::pow(other.r[i][d] - one.r[i][d], 2);
        }
    }
    const double h = c.at("h"), dx = c.at("dx"), before = kinetic(start);
    moved = std::sqrt(moved / static_cast<double>(n)) / dx;
    apart = std::sqrt(apart / static_cast<double>(n)) / dx;
    const std::array<double, 2> near{neighbours(one.r, wall.r, h), neighbours(other.r, wall.r, h)};
    const std::array<double, 2> energy{kinetic(one) / before, kinetic(other) / before};
    std::printf(
        "neighbours at the start %.1f, at the end %.1f and %.1f; kinetic energy %.3f and %.3f of that at the start; "
        "highest pressure %.0f and %.0f Pa; way of the particles %.2f dx rms, their distance %.3f dx\n",
        neighbours(start.r, wall.r, h), near[0], near[1], energy[0], energy[1], highestPressure(one),
        highestPressure(other), moved, apart
    );
    return std::abs(near[0] / near[1] - 1) < 0.05 && std::abs(energy[0] - energy[1]) < 0.1 && apart < 0.3;
}

} // namespace

int main(int argc, char** argv)
try
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 4 && words[0] == "write")
    {
        write(words[1], words[3], readConstants(words[2]));
        return 0;
    }
    if (words.size() == 4 && words[0] == "compare")
    {
        return compare(words[1], readConstants(words[2]), words[3]) ? 0 : 1;
    }
    std::cerr << "Usage: dualCase write|compare <our case> <file of constants> <name, or file of particles>\n";
    return 1;
}
catch (const std::exception& error)
{
    std::cerr << "dualCase: " << error.what() << "\n";
    return 1;
}
