// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunLog.hpp"

#include <cstdio>
#include <ctime>
#include <iostream>

namespace slosh
{

RunLog::RunLog(
    const Case& theCase, const Controls& time, const Scene& scene, const WeaklyCompressible& solver,
    const FunctionObjects& functions, const std::vector<std::string>& warnings
)
    : time_(time), scene_(scene), solver_(solver), beginTime_(time.time()), beginIndex_(time.index()),
      nextReport_(time.time()), progress_(time)
{
    const Particles& particles = solver.particles();
    std::cout << "Create time\n\nStart from " << time.startName() << ", step " << time.index() << "\n"
              << "Particles: " << particles.nFluid << " liquid, " << particles.nWall << " wall, spacing "
              << particles.spacing << " m\n"
              << "Motion: " << scene.motion->description() << "\n"
              << "Speed of sound: " << scene.equationOfState.c0 << " m/s, h = " << scene.kernel.smoothingLength()
              << " m\n";
    std::cout << "Scheme: " << theCase.scheme().name << "\n";
    for (const auto& part : theCase.schemeParts())
    {
        std::cout << "    " << part << "\n";
    }
    for (const auto& line : solver.description())
    {
        std::cout << line << "\n";
    }
    if (functions.names().empty())
    {
        std::cout << "omitted: functions (probes, gauges, forces ...)\n";
    }
    std::cout << "Functions:";
    for (const auto& name : functions.names())
    {
        std::cout << " " << name;
    }
    std::cout << (functions.names().empty() ? " none\n" : "\n");
    for (const auto& entry : theCase.unusedEntries())
    {
        std::cout << "Not used: " << entry << "\n";
    }
    for (const auto& warning : warnings)
    {
        std::cout << "--> FOAM Warning: " << warning << "\n";
    }
    std::cout << "\nStarting time loop\n\n" << std::flush;
}

double RunLog::cpuSeconds() const
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void RunLog::printTimes() const
{
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - begin_;
    std::cout << "ExecutionTime = " << cpuSeconds() << " s  ClockTime = " << static_cast<long>(clock.count()) << " s\n";
}

void RunLog::printProfile() const
{
    const Profile& profile = solver_.profile();
    const double total = profile.total();
    std::cout << "Wall-clock seconds and share by kind of work:\n";
    for (std::size_t k = 0; k < workNames.size(); ++k)
    {
        const double seconds = profile.seconds(static_cast<Work>(k));
        if (seconds > 0)
        {
            char line[80];
            std::snprintf(
                line, sizeof line, "    %-26s %10.2f %6.1f %%\n", workNames[k].data(), seconds, 100 * seconds / total
            );
            std::cout << line;
        }
    }
    std::cout << "Total over right-hand sides: " << total / profile.seconds(Work::rightHandSides) << "\n";
}

void RunLog::step()
{
    if (time_.time() < nextReport_ && !time_.isWriteTime() && time_.running())
    {
        progress_.step(solver_.outside(), solver_.stoppedAtWalls());
        return;
    }
    nextReport_ = time_.time() + (time_.endTime() - beginTime_) / 200;
    progress_.clear();
    const double c0 = scene_.equationOfState.c0;
    const double co = time_.deltaT() * (c0 + solver_.maxSpeed()) / scene_.kernel.smoothingLength();
    std::cout << "Time = " << time_.timeName() << "\n\nCourant number (c0 + |v|) dt/h: " << co
              << "\ndeltaT = " << time_.deltaT() << "\nmax |v| = " << solver_.maxSpeed()
              << " m/s, density deviation = " << solver_.maxDensityDeviation() << "\n";
    printTimes();
    std::cout << "\n" << std::flush;
}

void RunLog::say(const std::string& text)
{
    if (!text.empty())
    {
        progress_.clear();
        std::cout << text << "\n" << std::flush;
    }
}

void RunLog::finish()
{
    progress_.clear();
    if (const std::string cause = time_.stoppedBy(); !cause.empty())
    {
        std::cout << "Stopped by " << cause << " at t = " << time_.timeName() << " s, before endTime "
                  << time_.endTime() << " s; startFrom latestTime continues from the last written time\n\n";
    }
    const long steps = time_.index() - beginIndex_;
    std::cout << "Steps: " << steps << ", evaluations of the rates: " << solver_.evaluations()
              << ", neighbour lists rebuilt: " << solver_.rebuilds() << " ("
              << (steps > 0 ? 100.0 * static_cast<double>(solver_.rebuilds()) / static_cast<double>(steps) : 0)
              << " in 100 steps)\nParticles stopped at walls, not held by pressure: " << solver_.stoppedAtWalls()
              << " times\nMemory of particles, lists and records: " << static_cast<double>(solver_.bytes()) / 1e6
              << " MB, " << solver_.bytes() / static_cast<std::size_t>(solver_.particles().size())
              << " B per particle\n";
    printProfile();
    printTimes();
}

} // namespace slosh
