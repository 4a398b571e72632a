// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Controls.hpp"

#include "case/signals.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <iomanip>
#include <limits>
#include <sstream>

namespace slosh
{

namespace
{

/// The time directory startFrom asks for.
TimeDirectory chooseStart(const Case& theCase, const Dictionary& dict)
{
    const auto times = theCase.times();
    const std::string from =
        dict.choiceOr("startFrom", "latestTime", {"firstTime", "startTime", "latestTime"}, "startFrom");
    if (times.empty())
    {
        throw CaseError(
            "the case " + theCase.root().string() +
            " has no time directory with particles to start from; run blockParticles first"
        );
    }
    if (from != "startTime")
    {
        return from == "firstTime" ? times.front() : times.back();
    }
    const double wanted = dict.scalar("startTime", unit::second);
    for (const auto& time : times)
    {
        if (std::abs(time.value - wanted) <= 1e-9 * std::max(1.0, std::abs(wanted)))
        {
            return time;
        }
    }
    std::ostringstream message;
    message << "'startTime' is " << wanted << dict.placeOf("startTime") << "; there is no such time directory, only";
    for (const auto& time : times)
    {
        message << " " << time.name;
    }
    throw CaseError(message.str(), CaseError::Kind::input);
}

} // namespace

Controls::Controls(const Case& theCase) : root_(theCase.root()), dict_(theCase.dictionary("system/controlDict"))
{
    const TimeDirectory start = chooseStart(theCase, dict_);
    startTime_ = start.value;
    startName_ = start.name;
    now_.time = before_.time = startTime_;
    read();
    if (endTime_ < startTime_)
    {
        std::ostringstream message;
        message << "'endTime' is " << endTime_ << dict_.placeOf("endTime") << "; the run starts at " << startTime_
                << " s, after it";
        throw CaseError(message.str(), CaseError::Kind::input);
    }
    currentDeltaT_ = previousDeltaT_ = step_.deltaT;
    noteFiles();
}

void Controls::read()
{
    dict_.allow({"startFrom"});
    dict_.ignore({"startTime"}); // OpenFOAM's cases have it, whatever startFrom says
    const std::string stopAt =
        dict_.choiceOr("stopAt", "endTime", {"endTime", "writeNow", "noWriteNow", "nextWrite"}, "stopAt");
    stopAt_ = stopAt == "endTime"      ? StopAt::endTime
              : stopAt == "writeNow"   ? StopAt::writeNow
              : stopAt == "noWriteNow" ? StopAt::noWriteNow
                                       : StopAt::nextWrite;
    endTime_ = dict_.scalar("endTime", unit::second);
    step_ = TimeStepControl::read(dict_);

    write_ = Schedule::read(dict_, "write");
    writeOptions_.format = dict_.choiceOr("writeFormat", "ascii", {"ascii", "binary"}, "writeFormat") == "binary"
                               ? WriteFormat::binary
                               : WriteFormat::ascii;
    writeOptions_.precision = static_cast<int>(dict_.labelOr("writePrecision", 6, between(1, 17)));
    if (dict_.flagOr("writeCompression", false))
    {
        throw dict_.errorAt("writeCompression", "is on, which is not supported; leave it off:");
    }
    const std::string format =
        dict_.choiceOr("timeFormat", "general", {"general", "fixed", "scientific"}, "timeFormat");
    timeFormat_ = format == "general" ? 'g' : format == "fixed" ? 'f' : 'e';
    timePrecision_ = static_cast<int>(dict_.labelOr("timePrecision", 6, between(1, 17)));
    purgeWrite_ = static_cast<int>(dict_.labelOr("purgeWrite", 0, between(0, 1e9)));
    modifiable_ = dict_.flagOr("runTimeModifiable", false);
    dict_.allow({"functions"}); // read by FunctionObjects
    dict_.ignore(
        {"application", "libs", "graphFormat", "maxAlphaCo", "DebugSwitches", "InfoSwitches", "OptimisationSwitches"}
    );
    dict_.refuseUnknown();
}

void Controls::noteFiles()
{
    std::error_code none; // a file that is not there now has no time, and will have one
    files_.clear();
    for (const auto& file : dict_.files())
    {
        files_[root_ / file] = std::filesystem::last_write_time(root_ / file, none);
    }
}

std::string Controls::readIfModified(const std::function<void(const Controls&)>& check)
{
    if (!modifiable_ || now_.clock - lookedAt_ < 0.2)
    {
        return {};
    }
    lookedAt_ = now_.clock;
    std::error_code none;
    if (std::all_of(
            files_.begin(), files_.end(),
            [&](const auto& file) { return std::filesystem::last_write_time(file.first, none) == file.second; }
        ))
    {
        return {};
    }
    Controls changed = *this;
    try
    {
        changed.dict_ = Case(root_).dictionary("system/controlDict");
        changed.read();
        check(changed);
        changed.noteFiles();
    }
    catch (const CaseError& error)
    {
        noteFiles();
        return std::string("--> FOAM Warning: system/controlDict has changed and has an error; what it said before "
                           "holds:\n") +
               error.what() + "\n";
    }
    *this = changed;
    return "system/controlDict has changed: read again (functions are as they were at the start)\n";
}

void Controls::resume(double time, long index, double deltaT)
{
    now_.time = before_.time = time;
    now_.index = before_.index = index;
    currentDeltaT_ = previousDeltaT_ = deltaT;
}

bool Controls::running() const
{
    return !stopped_ && stopAt_ != StopAt::noWriteNow && now_.time < endTime_ - 1e-9 * std::max(currentDeltaT_, 1e-12);
}

std::string Controls::stoppedBy() const
{
    if (stopAt_ == StopAt::noWriteNow)
    {
        return "stopAt noWriteNow";
    }
    if (!stopped_)
    {
        return {};
    }
    const int signal = stopSignal();
    return signal == SIGINT               ? "SIGINT"
           : signal == SIGTERM            ? "SIGTERM"
           : stopAt_ == StopAt::nextWrite ? "stopAt nextWrite"
                                          : "stopAt writeNow";
}

double Controls::limitDeltaT(double wanted, double instant) const
{
    wanted = std::min(wanted, step_.maxDeltaT);
    const double remaining = std::min({endTime_, write_.nextInstant(now_.time), instant}) - now_.time;
    const double steps = std::ceil(remaining / wanted - 1e-9);
    return steps <= 1 ? remaining : steps == 2 ? remaining / 2 : wanted;
}

void Controls::advance(double dt)
{
    before_ = now_;
    previousDeltaT_ = currentDeltaT_;
    currentDeltaT_ = dt;
    const double next = std::min(endTime_, write_.nextInstant(now_.time));
    now_.time += dt;
    if (std::abs(now_.time - next) < 1e-8 * dt)
    {
        now_.time = next;
    }
    ++now_.index;
    now_.clock = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    now_.processor = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    const bool stopNow = stopAt_ == StopAt::writeNow || stopSignal() != 0;
    if (write_.isDue(before_, now_) || stopNow || writeRequested())
    {
        ++now_.writes;
    }
    stopped_ = stopNow || (stopAt_ == StopAt::nextWrite && isWriteTime());
    now_.ends = !running();
}

void Controls::stepBack()
{
    now_ = before_;
    currentDeltaT_ = previousDeltaT_;
}

std::string Controls::timeName(double time) const
{
    // Two steps must not share a name: more digits where these do not tell them apart.
    for (int precision = timePrecision_;; ++precision)
    {
        std::ostringstream name;
        if (timeFormat_ != 'g')
        {
            name << (timeFormat_ == 'f' ? std::fixed : std::scientific);
        }
        name << std::setprecision(precision) << time;
        if (precision >= 17 || std::abs(std::stod(name.str()) - time) < 0.25 * currentDeltaT_)
        {
            return name.str();
        }
    }
}

void Controls::purge(const Case& theCase, const std::string& written)
{
    written_.push_back(written);
    while (purgeWrite_ > 0 && static_cast<int>(written_.size()) > purgeWrite_)
    {
        if (written_.front() != startName_)
        {
            theCase.removeTime(written_.front());
        }
        written_.erase(written_.begin());
    }
}

} // namespace slosh
