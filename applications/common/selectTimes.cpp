// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/selectTimes.hpp"

#include "base/CaseError.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace slosh
{

namespace
{

CaseError malformed(const std::string& ranges)
{
    return CaseError("-time is " + ranges + "; expected ranges such as 0.5:2 :3 5: or values [s]");
}

double number(const std::string& text, const std::string& ranges)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    {
        throw malformed(ranges);
    }
    return value;
}

/// Marks the times that one range (a:b, :b, a: or a value) covers.
void choose(
    const std::string& range, const std::string& ranges, const std::vector<TimeDirectory>& times,
    std::vector<bool>& chosen
)
{
    const std::size_t colon = range.find(':');
    if (colon == std::string::npos)
    {
        const double wanted = number(range, ranges);
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < times.size(); ++i)
        {
            if (std::abs(times[i].value - wanted) < std::abs(times[nearest].value - wanted))
            {
                nearest = i;
            }
        }
        chosen[nearest] = true;
        return;
    }
    const std::string from = range.substr(0, colon), to = range.substr(colon + 1);
    const double low = from.empty() ? -std::numeric_limits<double>::infinity() : number(from, ranges);
    const double high = to.empty() ? std::numeric_limits<double>::infinity() : number(to, ranges);
    if (low > high)
    {
        throw malformed(ranges);
    }
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        chosen[i] = chosen[i] || (times[i].value >= low && times[i].value <= high);
    }
}

} // namespace

void addTimeOptions(Program& program)
{
    program.addOption("time", "ranges", "times to select, e.g. '0.5:2', ':3', '1,2,5:'; a value: the nearest time");
    program.addOption("latestTime", "", "select the latest time");
    program.addOption("noZero", "", "omit time 0");
}

std::vector<TimeDirectory> selectTimes(const Case& theCase, const Program& program)
{
    const std::vector<TimeDirectory> times = theCase.times();
    if (times.empty())
    {
        throw CaseError(
            "the case " + theCase.root().string() + " has no time directory with particles; run blockParticles first"
        );
    }
    std::vector<bool> chosen(times.size(), !program.has("time") && !program.has("latestTime"));
    if (program.has("time"))
    {
        const std::string ranges = program.value("time");
        for (std::size_t begin = ranges.find_first_not_of(", "); begin != std::string::npos;)
        {
            const std::size_t end = std::min(ranges.find_first_of(", ", begin), ranges.size());
            choose(ranges.substr(begin, end - begin), ranges, times, chosen);
            begin = ranges.find_first_not_of(", ", end);
        }
    }
    if (program.has("latestTime"))
    {
        chosen.back() = true;
    }
    std::vector<TimeDirectory> selected;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        if (chosen[i] && !(program.has("noZero") && times[i].value == 0))
        {
            selected.push_back(times[i]);
        }
    }
    if (selected.empty())
    {
        throw CaseError(
            "-time selects no time of the case; expected times from " + times.front().name + " to " + times.back().name
        );
    }
    return selected;
}

} // namespace slosh
