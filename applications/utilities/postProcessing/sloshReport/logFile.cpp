// SPDX-License-Identifier: GPL-3.0-or-later
#include "logFile.hpp"

#include "base/CaseError.hpp"

#include <cctype>
#include <fstream>
#include <regex>

namespace slosh
{

LogFile LogFile::read(const std::filesystem::path& file)
{
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
    {
        throw CaseError(file.string() + ": cannot read the log", CaseError::Kind::input);
    }
    LogFile log;
    bool isOurs = false, looping = false, atEnd = false;
    std::smatch match;
    for (std::string line; std::getline(in, line);)
    {
        const auto is = [&](const char* pattern) { return std::regex_match(line, match, std::regex(pattern)); };
        const auto begins = [&](const std::string& words) { return line.rfind(words, 0) == 0; };
        if (looping && !atEnd && line.find_first_of("=:") == std::string::npos && line != "End")
        {
            continue; // most lines of a long log
        }
        if (begins("| SloshSPH ") && is("\\| SloshSPH ([^:]+):.*"))
        {
            log = {}; // a log that a second run was appended to
            log.version = match[1];
            isOurs = looping = atEnd = false;
        }
        else if (begins("Exec   :"))
        {
            isOurs = line.find("sloshSPHFoam") != std::string::npos;
        }
        else if (!looping && is("(?:Date|Time)   : (.*)"))
        {
            log.date += (log.date.empty() ? "" : " ") + match[1].str();
        }
        else if (begins("--> FOAM Warning: "))
        {
            log.warnings.push_back(line.substr(18));
        }
        else if (!looping && (begins("pair loop: ") || begins("omitted: ")))
        {
            log.words.push_back(line);
        }
        else if (begins("Starting time loop"))
        {
            looping = true;
        }
        else if (begins("Time = "))
        {
            log.lastTime = line.substr(7);
        }
        else if (begins("Stopped by "))
        {
            log.warnings.push_back(line);
        }
        else if (begins("Steps: ") && is("Steps: ([0-9]+), evaluations of the rates: ([0-9]+), (.*): (.*)"))
        {
            atEnd = true;
            log.facts = {{"Steps", match[1]}, {"Evaluations of the rates", match[2]}, {match[3], match[4]}};
        }
        else if (atEnd && is("    (.*?) +([0-9.]+) +([0-9.]+ %)"))
        {
            log.work.push_back({match[1], match[2], match[3]});
        }
        else if (atEnd && is("ExecutionTime = (.*)  ClockTime = (.*)"))
        {
            log.facts.emplace_back("CPU time", match[1]);
            log.facts.emplace_back("Wall-clock time", match[2]);
        }
        else if (atEnd && !begins("Wall-clock seconds") && is("([A-Z][^:=]*): (.*)"))
        {
            log.facts.emplace_back(match[1], match[2]);
        }
        log.ended = line == "End" || (log.ended && line.empty());
    }
    if (!isOurs)
    {
        throw CaseError(file.string() + ": not a log of sloshSPHFoam", CaseError::Kind::input);
    }
    for (auto& [name, what] : log.facts)
    {
        name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    }
    return log;
}

} // namespace slosh
