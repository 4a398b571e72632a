// SPDX-License-Identifier: GPL-3.0-or-later
#include "case/Controls.hpp"

#include "case/signals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <ctime>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string_view>

namespace slosh
{

namespace
{

namespace controlDict
{

constexpr Key application{
    .name = "application", .leftOut = "none", .example = "sloshSPHFoam", .sentence = "for information only"};

constexpr Key startTime{
    .name = "startTime", .example = "0", .unit = unit::second, .sentence = "the time directory to start from"};
constexpr Key startFrom{
    .name = "startFrom", .otherwise = "latestTime", .sentence = "which time directory to start from", .options = [] {
        return Options{{"firstTime"}, {"startTime", "", [] { return Keys{startTime}; }}, {"latestTime"}};
    }};
constexpr Key stopAt{
    .name = "stopAt",
    .otherwise = "endTime",
    .options = []
    {
        return Options{
            {"endTime"},
            {"writeNow", "after the next step, with output"},
            {"noWriteNow", "immediately, without output"},
            {"nextWrite", "after the next written time"}};
    }};
constexpr Key endTime{.name = "endTime", .example = "20", .unit = unit::second};

constexpr Key purgeWrite{
    .name = "purgeWrite",
    .otherwise = "0",
    .range = between(0, 1e9),
    .sentence = "number of time directories to keep, the newest ones; 0: all"};
constexpr Key writeFormat{.name = "writeFormat", .otherwise = "ascii", .example = "binary", .options = [] {
                              return Options{{"ascii"}, {"binary", "a restarted run continues bit for bit"}};
                          }};
constexpr Key writePrecision{
    .name = "writePrecision",
    .otherwise = "6",
    .example = "8",
    .range = between(1, 17),
    .sentence = "digits of ascii files and of samples"};
constexpr Key writeCompression{
    .name = "writeCompression", .otherwise = "no", .sentence = "only no is supported: files are never compressed"};
constexpr Key timeFormat{
    .name = "timeFormat", .otherwise = "general", .sentence = "format of time directory names", .options = [] {
        return Options{{"general"}, {"fixed"}, {"scientific"}};
    }};
constexpr Key timePrecision{
    .name = "timePrecision",
    .otherwise = "6",
    .range = between(1, 17),
    .sentence = "digits of time directory names; increased if two times would have the same name"};
constexpr Key runTimeModifiable{
    .name = "runTimeModifiable",
    .otherwise = "no",
    .example = "yes",
    .sentence = "whether to re-read all entries except startFrom, startTime and functions when this file or an "
                "included one has changed"};

constexpr Key functions{
    .name = "functions",
    .leftOut = "none",
    .example = "#include \"probesDict\"",
    .sentence = "functions executed while the solver runs",
    .entries = noKeys};

constexpr std::array<std::string_view, 6> ofOthers = {"libs",          "graphFormat",  "maxAlphaCo",
                                                      "DebugSwitches", "InfoSwitches", "OptimisationSwitches"};

} // namespace controlDict

/// The time directory startFrom asks for.
TimeDirectory chooseStart(const Case& theCase, const Dictionary& dict)
{
    const auto times = theCase.times();
    const std::string from = dict.choice(controlDict::startFrom, "startFrom");
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
    const double wanted = dict.scalar(controlDict::startTime);
    for (const auto& time : times)
    {
        if (std::abs(time.value - wanted) <= 1e-9 * std::max(1.0, std::abs(wanted)))
        {
            return time;
        }
    }
    std::ostringstream message;
    message << "is " << wanted << "; no such time directory; expected one of";
    for (const auto& time : times)
    {
        message << " " << time.name;
    }
    throw dict.errorAt(controlDict::startTime, message.str());
}

} // namespace

Keys controlDictKeys()
{
    using namespace controlDict;
    const Keys start = {application, startFrom, stopAt, endTime};
    const Keys writing = {purgeWrite, writeFormat,   writePrecision,    writeCompression,
                          timeFormat, timePrecision, runTimeModifiable, functions};
    const Keys unread = withoutEffect({ofOthers.begin(), ofOthers.end()});
    return joined(start, joined(timeStepKeys(), joined(scheduleKeys(), joined(writing, unread))));
}

Key endTimeKey()
{
    return controlDict::endTime;
}

Key writePrecisionKey()
{
    return controlDict::writePrecision;
}

Key functionsKey()
{
    return controlDict::functions;
}

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
        message << "is " << endTime_ << "; expected at least the start time of the run, " << startTime_ << " s";
        throw dict_.errorAt(controlDict::endTime, message.str());
    }
    currentDeltaT_ = previousDeltaT_ = step_.deltaT;
    noteFiles();
}

void Controls::read()
{
    using namespace controlDict;
    // OpenFOAM's cases have startTime, whatever startFrom says.
    dict_.ignore({std::string(application.name), std::string(controlDict::startTime.name)});
    dict_.ignore({ofOthers.begin(), ofOthers.end()});
    const std::string stop = dict_.choice(stopAt, "stopAt");
    stopAt_ = stop == "endTime"      ? StopAt::endTime
              : stop == "writeNow"   ? StopAt::writeNow
              : stop == "noWriteNow" ? StopAt::noWriteNow
                                     : StopAt::nextWrite;
    endTime_ = dict_.scalar(controlDict::endTime);
    step_ = TimeStepControl::read(dict_);

    write_ = Schedule::read(dict_);
    writeOptions_.format =
        dict_.choice(writeFormat, "writeFormat") == "binary" ? WriteFormat::binary : WriteFormat::ascii;
    writeOptions_.precision = static_cast<int>(dict_.label(writePrecision));
    if (dict_.flag(writeCompression))
    {
        throw dict_.errorAt(writeCompression, "is on, which is not supported; expected off");
    }
    const std::string format = dict_.choice(timeFormat, "timeFormat");
    timeFormat_ = format == "general" ? 'g' : format == "fixed" ? 'f' : 'e';
    timePrecision_ = static_cast<int>(dict_.label(timePrecision));
    purgeWrite_ = static_cast<int>(dict_.label(purgeWrite));
    modifiable_ = dict_.flag(runTimeModifiable);
    dict_.refuseUnknown(controlDictKeys());
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
        return std::string("--> FOAM Warning: system/controlDict has changed and has an error; the previous settings "
                           "are kept:\n") +
               error.what() + "\n";
    }
    *this = changed;
    return "system/controlDict has changed: read again (functions are unchanged)\n";
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
