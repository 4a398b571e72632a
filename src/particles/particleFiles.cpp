// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particleFiles.hpp"

#include "base/writeFile.hpp"
#include "case/foamFile.hpp"
#include "dictionary/tokenize.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

/// The clouds of a time directory, and the range of particles that each holds.
constexpr std::pair<const char*, ParticleRange> clouds[] = {
    {"fluid", ParticleRange::liquid}, {"wall", ParticleRange::wall}};

void writeCloud(
    const fs::path& root, const std::string& name, const std::string& cloud, const Particles& particles,
    ParticleRange range, const WriteOptions& options
)
{
    const std::string location = name + "/lagrangian/" + cloud;
    const std::ptrdiff_t first = particles.first(range), n = particles.size(range);
    particles.forEachField(
        [&](const std::string& field, ParticleRange has, const auto& values)
        {
            if (has != ParticleRange::all && has != range)
            {
                return;
            }
            const auto part = std::span(values).subspan(first - particles.first(has), n);
            if constexpr (std::is_same_v<std::decay_t<decltype(values)>, std::vector<Vec>>)
            {
                if (field == "positions")
                {
                    return writePositions(root, location, part, options);
                }
            }
            writeField(root, location, field, part, options);
        }
    );

    Dictionary properties("cloudProperties");
    Dictionary processor("processor0");
    processor.set("particleCount", static_cast<long>(n));
    properties.set("geometry", std::string_view("positions"));
    properties.set("processor0", processor);
    const std::string uniform = name + "/uniform/lagrangian/" + cloud;
    writeFile(
        root / uniform / "cloudProperties",
        foamHeader("dictionary", uniform, "cloudProperties") + "\n" + properties.text()
    );
}

/// Files of the cloud that hold a field of `more`.
std::vector<std::string> moreFields(const fs::path& folder, const Particles& particles)
{
    std::vector<std::string> names;
    for (const auto& item : fs::directory_iterator(folder))
    {
        const fs::path file = item.path().extension() == ".gz" ? item.path().stem() : item.path().filename();
        // Not the copies that editors and people keep: U.orig, U~.
        if (item.is_regular_file() && file.string().find_first_of(".~#") == std::string::npos)
        {
            names.push_back(file.string());
        }
    }
    particles.forEachField([&](const auto& field, ParticleRange, const auto&)
                           { names.erase(std::remove(names.begin(), names.end(), field), names.end()); });
    std::sort(names.begin(), names.end());
    return names;
}

void readCloud(
    const fs::path& root, const std::string& location, Particles& particles, ParticleRange range,
    const std::vector<Vec>& positions, std::vector<Field>& more
)
{
    const auto n = static_cast<long>(positions.size());
    const std::ptrdiff_t first = particles.first(range);
    const auto put = [&](const auto& values, auto& target)
    { std::copy(values.begin(), values.end(), target.begin() + first); };
    put(positions, particles.r);
    put(readVectorField(root, location + "/U", n), particles.v);
    put(readScalarField(root, location + "/p", n), particles.p);
    put(readScalarField(root, location + "/rho", n), particles.rho);
    put(readLabelField(root, location + "/origId", n), particles.id);
    for (const std::string& name : moreFields(root / location, particles))
    {
        if (auto values = readFieldIfOne(root, location + "/" + name, n))
        {
            more.push_back({name, range, std::move(*values)});
        }
    }

    std::vector<int> ids(particles.id.begin() + first, particles.id.begin() + first + n);
    std::sort(ids.begin(), ids.end());
    if (const auto twice = std::adjacent_find(ids.begin(), ids.end()); twice != ids.end())
    {
        throw CaseError(
            location + "/origId: the id " + std::to_string(*twice) + " occurs twice", CaseError::Kind::input
        );
    }
    for (long i = 0; i < n; ++i)
    {
        const double rho = particles.rho[first + i];
        if (!(rho > 0))
        {
            throw CaseError(
                location + "/rho: value number " + std::to_string(i) + " (from 0) is " + std::to_string(rho) +
                    "; expected a density > 0 [kg/m^3]",
                CaseError::Kind::input
            );
        }
    }
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
           "\n// Energy budget [J] accumulated since time `since` [s] by the function energies { budget yes; }.\n" +
           dict.text();
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
           "\n// x = c + R X: position of a point X of the tank; velocities and accelerations in the inertial "
           "frame.\n" +
           tank.text();
}

} // namespace

void TimeState::requireStopsOn(std::size_t parts) const
{
    if (!stops.empty() && stops.size() != parts)
    {
        throw CaseError(
            "<time>/uniform/stops: impulses on " + std::to_string(stops.size()) +
                " parts of the tank (walls and bodies) found; expected " + std::to_string(parts),
            CaseError::Kind::input
        );
    }
}

void writeTime(
    const Case& theCase, const std::string& name, const Particles& particles, const TimeState& state,
    const WriteOptions& options
)
{
    const fs::path& root = theCase.root();
    // Put together aside, so that a directory has its name only when it is complete.
    const fs::path stage = root / ("." + name + ".beingWritten");
    const fs::path old = root / ("." + name + ".old");
    std::error_code failure;
    fs::remove_all(stage, failure);
    try
    {
        for (const auto& [cloud, range] : clouds)
        {
            writeCloud(stage, name, cloud, particles, range, options);
        }
        writeFile(stage / name / "uniform/time", timeText(name, state));
        writeFile(stage / name / "uniform/tankState", tankText(name, particles, state));
        if (state.budget)
        {
            writeFile(stage / name / "uniform/energyBudget", budgetText(name, *state.budget));
        }
        if (!state.stops.empty())
        {
            std::vector<Vec> stops;
            for (const Wrench& impulse : state.stops)
            {
                stops.insert(stops.end(), {impulse.force, impulse.moment});
            }
            writeField(stage, name + "/uniform", "stops", std::span<const Vec>(stops), options);
        }
        if (!state.sound.empty())
        {
            writeField(stage, name + "/uniform", "sound", std::span<const double>(state.sound), options);
        }
        if (particles.bricks.size() > 2)
        {
            const std::vector<int> bricks(particles.bricks.begin(), particles.bricks.end());
            writeField(stage, name + "/uniform", "bricks", std::span<const int>(bricks), options);
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

/// Whether `named` is x to some number of digits.
static bool isRoundedTo(double x, double named)
{
    for (int digits = 1; digits <= 17; ++digits)
    {
        std::ostringstream text;
        text << std::setprecision(digits) << x;
        if (std::stod(text.str()) == named)
        {
            return true;
        }
    }
    return false;
}

Particles readTime(const Case& theCase, const std::string& name, TimeState& state)
{
    const fs::path& root = theCase.root();
    const Dictionary time = theCase.dictionary(name + "/uniform/time");
    time.ignore({"name", "deltaT0"}); // for OpenFOAM's programs
    state.time = time.scalar("value", unit::second);
    state.index = time.label("index", notNegative);
    state.deltaT = time.scalar("deltaT", unit::second, notNegative);
    state.renamed.reset();
    if (double named = 0; isNumber(name, named) && !isRoundedTo(state.time, named))
    {
        state.renamed = state.time;
        state.time = named;
        state.index = 0;
    }
    const auto times = theCase.times();
    state.begin = times.empty() ? state.time : std::min(times.front().value, state.time);

    const Dictionary tank = theCase.dictionary(name + "/uniform/tankState");
    state.frame = frameNamed(tank.choice("frame", {"tank", "inertial"}, "frame"));
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
    const std::string lagrangian = name + "/lagrangian/";
    const auto fluid = readPositions(root, lagrangian + "fluid/positions");
    const auto wall = readPositions(root, lagrangian + "wall/positions");
    if (fluid.empty())
    {
        throw CaseError(
            lagrangian + "fluid/positions: no particles found; expected at least one", CaseError::Kind::input
        );
    }
    particles.resize(static_cast<std::ptrdiff_t>(fluid.size()), static_cast<std::ptrdiff_t>(wall.size()));
    particles.mass = tank.scalar("mass", unit::none, positive);
    particles.spacing = tank.scalar("spacing", unit::metre, positive);
    std::vector<Field> more;
    for (const auto& [cloud, range] : clouds)
    {
        readCloud(root, lagrangian + cloud, particles, range, range == ParticleRange::liquid ? fluid : wall, more);
    }
    particles.more = std::move(more);
    if (const std::string file = name + "/uniform/bricks"; fs::exists(root / file))
    {
        const std::vector<int> bricks = readLabelField(root, file);
        if (bricks.empty() || bricks.front() != 0 || bricks.back() != particles.nFluid ||
            !std::is_sorted(bricks.begin(), bricks.end()))
        {
            throw CaseError(
                file + ": expected increasing ranges from 0 to the " + std::to_string(particles.nFluid) +
                    " fluid particles",
                CaseError::Kind::input
            );
        }
        particles.bricks.assign(bricks.begin(), bricks.end());
    }
    state.stops.clear();
    if (const std::string file = name + "/uniform/stops"; fs::exists(root / file))
    {
        const std::vector<Vec> stops = readVectorField(root, file);
        if (stops.size() % 2 != 0)
        {
            throw CaseError(file + ": expected pairs of an impulse and its moment", CaseError::Kind::input);
        }
        for (std::size_t k = 0; k < stops.size(); k += 2)
        {
            state.stops.push_back({stops[k], stops[k + 1]});
        }
    }
    state.sound.clear();
    if (const std::string file = name + "/uniform/sound"; fs::exists(root / file))
    {
        state.sound = readScalarField(root, file);
    }
    return particles;
}

} // namespace slosh
