// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particleFiles.hpp"

#include "base/writeFile.hpp"
#include "case/foamFile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

template <class T>
std::span<const T> part(const std::vector<T>& values, std::ptrdiff_t first, std::ptrdiff_t n)
{
    return std::span<const T>(values).subspan(first, n);
}

void writeCloud(const fs::path& root, const std::string& name, const std::string& cloud, const Particles& particles,
                std::ptrdiff_t first, std::ptrdiff_t n, const WriteOptions& options)
{
    const std::string location = name + "/lagrangian/" + cloud;
    writePositions(root, location, part(particles.r, first, n), options);
    writeField(root, location, "U", part(particles.v, first, n), options);
    writeField(root, location, "p", part(particles.p, first, n), options);
    writeField(root, location, "rho", part(particles.rho, first, n), options);
    writeField(root, location, "origId", part(particles.id, first, n), options);

    Dictionary properties("cloudProperties");
    Dictionary processor("processor0");
    processor.set("particleCount", static_cast<long>(n));
    properties.set("geometry", std::string_view("positions"));
    properties.set("processor0", processor);
    const std::string uniform = name + "/uniform/lagrangian/" + cloud;
    writeFile(root / uniform / "cloudProperties",
              foamHeader("dictionary", uniform, "cloudProperties") + "\n" + properties.text());
}

void readCloud(const fs::path& root, const std::string& location, Particles& particles, std::ptrdiff_t first,
               const std::vector<Vec>& positions)
{
    const auto n = static_cast<long>(positions.size());
    const auto put = [&](const auto& values, auto& target)
    { std::copy(values.begin(), values.end(), target.begin() + first); };
    put(positions, particles.r);
    put(readVectorField(root, location + "/U", n), particles.v);
    put(readScalarField(root, location + "/p", n), particles.p);
    put(readScalarField(root, location + "/rho", n), particles.rho);
    put(readLabelField(root, location + "/origId", n), particles.id);

    std::vector<int> ids(particles.id.begin() + first, particles.id.begin() + first + n);
    std::sort(ids.begin(), ids.end());
    if (const auto twice = std::adjacent_find(ids.begin(), ids.end()); twice != ids.end())
    {
        throw CaseError("the id " + std::to_string(*twice) + " occurs twice in " + location + "/origId",
                        CaseError::Kind::input);
    }
    for (long i = 0; i < n; ++i)
    {
        const double rho = particles.rho[first + i];
        if (!(rho > 0))
        {
            throw CaseError("value number " + std::to_string(i) + " (from 0) is " + std::to_string(rho) + " in " +
                                location + "/rho; a density must be > 0",
                            CaseError::Kind::input);
        }
    }
}

/// The vectors of a wall particle's boundary layer with the names of their fields.
std::vector<std::pair<std::string, std::function<Vec&(BoundaryLayer&)>>> layerFields()
{
    std::vector<std::pair<std::string, std::function<Vec&(BoundaryLayer&)>>> fields = {
        {"layerU", [](BoundaryLayer& layer) -> Vec& { return layer.u; }},
        {"layerWay", [](BoundaryLayer& layer) -> Vec& { return layer.way; }}};
    for (std::size_t k = 0; k < BoundaryLayer::modes; ++k)
    {
        fields.emplace_back("layerMemory" + std::to_string(k),
                            [k](BoundaryLayer& layer) -> Vec& { return layer.z[k]; });
    }
    return fields;
}

void writeLayers(const fs::path& root, const std::string& location, std::vector<BoundaryLayer> layers,
                 const WriteOptions& options)
{
    std::vector<Vec> values(layers.size());
    for (const auto& [name, member] : layerFields())
    {
        std::transform(layers.begin(), layers.end(), values.begin(), member);
        writeField(root, location, name, values, options);
    }
}

std::vector<BoundaryLayer> readLayers(const fs::path& root, const std::string& location, long walls)
{
    std::vector<BoundaryLayer> layers(walls);
    for (const auto& [name, member] : layerFields())
    {
        const std::vector<Vec> values = readVectorField(root, location + "/" + name, walls);
        for (std::size_t w = 0; w < layers.size(); ++w)
        {
            member(layers[w]) = values[w];
        }
    }
    return layers;
}

std::string timeText(const std::string& name, const TimeState& state)
{
    Dictionary time("time");
    time.set("value", state.time);
    time.set("name", std::string_view("\"" + name + "\""));
    time.set("index", state.index);
    time.set("deltaT", state.deltaT);
    time.set("deltaT0", state.deltaT);
    return foamHeader("dictionary", name + "/uniform", "time") + "\n" + time.text();
}

/// The entries of <time>/uniform/energyBudget.
constexpr std::pair<const char*, double EnergyBudget::*> budgetEntries[] = {
    {"since", &EnergyBudget::since},         {"initial", &EnergyBudget::initial},
    {"work", &EnergyBudget::work},           {"positiveWork", &EnergyBudget::positiveWork},
    {"viscosity", &EnergyBudget::viscosity}, {"densityDiffusion", &EnergyBudget::densityDiffusion},
    {"walls", &EnergyBudget::walls},         {"reinitialisation", &EnergyBudget::reinitialisation},
    {"stops", &EnergyBudget::stops}};

std::string budgetText(const std::string& name, const EnergyBudget& budget)
{
    Dictionary dict("energyBudget");
    for (const auto& [entry, member] : budgetEntries)
    {
        dict.set(entry, budget.*member);
    }
    return foamHeader("dictionary", name + "/uniform", "energyBudget") +
           "\n// What the function energies { budget yes; } has added up since `since` [s], [J].\n" + dict.text();
}

std::string tankText(const std::string& name, const Particles& particles, const TimeState& state)
{
    Dictionary tank("tankState");
    tank.set("frame", std::string_view(nameOf(state.frame)));
    tank.set("mass", particles.mass);
    tank.set("spacing", particles.spacing);
    tank.set("c", state.tank.c);
    tank.set("velocity", state.tank.velocity);
    tank.set("acceleration", state.tank.acceleration);
    for (Eigen::Index row = 0; row < 3; ++row)
    {
        tank.set(std::string("R") + "xyz"[row], Vec(state.tank.R.row(row)));
    }
    tank.set("omega", state.tank.omega);
    tank.set("omegaDot", state.tank.omegaDot);
    return foamHeader("dictionary", name + "/uniform", "tankState") +
           "\n// x = c + R X: where a point X of the tank stands; velocities and accelerations in the inertial "
           "frame.\n" +
           tank.text();
}

} // namespace

void writeTime(const Case& theCase, const std::string& name, const Particles& particles, const TimeState& state,
               const WriteOptions& options)
{
    const fs::path& root = theCase.root();
    // Put together aside, so that a directory has its name only when it is complete.
    const fs::path stage = root / ("." + name + ".beingWritten");
    const fs::path old = root / ("." + name + ".old");
    std::error_code failure;
    fs::remove_all(stage, failure);
    try
    {
        writeCloud(stage, name, "fluid", particles, 0, particles.nFluid, options);
        if (!particles.meanDiffusion.empty())
        {
            writeField(stage, name + "/lagrangian/fluid", "meanDiffusion",
                       std::span<const double>(particles.meanDiffusion), options);
        }
        writeCloud(stage, name, "wall", particles, particles.nFluid, particles.nWall, options);
        if (!state.layers.empty())
        {
            writeLayers(stage, name + "/lagrangian/wall", state.layers, options);
        }
        writeFile(stage / name / "uniform/time", timeText(name, state));
        writeFile(stage / name / "uniform/tankState", tankText(name, particles, state));
        if (state.budget)
        {
            writeFile(stage / name / "uniform/energyBudget", budgetText(name, *state.budget));
        }
        if (!state.sound.empty())
        {
            writeField(stage, name + "/uniform", "sound", std::span<const double>(state.sound), options);
        }
        const fs::path foam = root / (theCase.name() + ".foam");
        if (!fs::exists(foam))
        {
            writeFile(foam, "");
        }
        if (fs::exists(root / name))
        {
            fs::rename(root / name, old);
        }
        fs::rename(stage / name, root / name);
        fs::remove_all(old);
        fs::remove_all(stage);
    }
    catch (const fs::filesystem_error& error)
    {
        fs::remove_all(stage, failure);
        throw CaseError("cannot write the time directory " + (root / name).string() + ": " + error.code().message());
    }
    catch (const CaseError&)
    {
        fs::remove_all(stage, failure);
        throw;
    }
}

Particles readTime(const Case& theCase, const std::string& name, TimeState& state)
{
    const fs::path& root = theCase.root();
    const Dictionary time = theCase.dictionary(name + "/uniform/time");
    time.ignore({"name", "deltaT0"}); // for OpenFOAM's programs
    state.time = time.scalar("value", unit::second);
    state.index = time.label("index", notNegative);
    state.deltaT = time.scalar("deltaT", unit::second, notNegative);
    const auto times = theCase.times();
    state.begin = times.empty() ? state.time : std::min(times.front().value, state.time);

    const Dictionary tank = theCase.dictionary(name + "/uniform/tankState");
    state.frame = tank.choice("frame", {"tank", "inertial"}, "frame") == "tank" ? Frame::tank : Frame::inertial;
    state.tank.c = tank.vector("c", unit::metre);
    state.tank.velocity = tank.vector("velocity", unit::velocity);
    state.tank.acceleration = tank.vector("acceleration", unit::acceleration);
    for (Eigen::Index row = 0; row < 3; ++row)
    {
        state.tank.R.row(row) = tank.vector(std::string("R") + "xyz"[row], unit::none);
    }
    state.tank.omega = tank.vector("omega", unit::radianPerSecond);
    state.tank.omegaDot = tank.vector("omegaDot", unit::none);

    state.budget.reset();
    if (const std::string file = name + "/uniform/energyBudget"; fs::exists(root / file))
    {
        const Dictionary budget = theCase.dictionary(file);
        state.budget.emplace();
        for (const auto& [entry, member] : budgetEntries)
        {
            *state.budget.*member = budget.scalar(entry, unit::none);
        }
    }

    Particles particles;
    const std::string clouds = name + "/lagrangian/";
    const auto fluid = readPositions(root, clouds + "fluid/positions");
    const auto wall = readPositions(root, clouds + "wall/positions");
    if (fluid.empty())
    {
        throw CaseError("there is no liquid in " + clouds + "fluid/positions", CaseError::Kind::input);
    }
    particles.resize(static_cast<std::ptrdiff_t>(fluid.size()), static_cast<std::ptrdiff_t>(wall.size()));
    particles.mass = tank.scalar("mass", unit::none, positive);
    particles.spacing = tank.scalar("spacing", unit::metre, positive);
    readCloud(root, clouds + "fluid", particles, 0, fluid);
    readCloud(root, clouds + "wall", particles, particles.nFluid, wall);
    if (fs::exists(root / (clouds + "fluid/meanDiffusion")))
    {
        particles.meanDiffusion = readScalarField(root, clouds + "fluid/meanDiffusion", particles.nFluid);
    }
    state.sound.clear();
    if (const std::string file = name + "/uniform/sound"; fs::exists(root / file))
    {
        state.sound = readScalarField(root, file);
    }
    state.layers.clear();
    if (fs::exists(root / (clouds + "wall/layerU")))
    {
        state.layers = readLayers(root, clouds + "wall", static_cast<long>(wall.size()));
    }
    return particles;
}

} // namespace slosh
