// SPDX-License-Identifier: GPL-3.0-or-later
#include "SampledFile.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace slosh
{

namespace
{

namespace fs = std::filesystem;

/// What a file holds, by its name: the order in the report, quantity, unit.
struct Kind
{
    int rank;
    std::string quantity, unit;
};

Kind kindOf(const std::string& file)
{
    static const std::map<std::string, Kind> kinds = {
        {"p", {1, "pressure", "Pa"}},
        {"height.dat", {2, "level", "m"}},
        {"force.dat", {3, "force", "N"}},
        {"moment.dat", {4, "moment", "N m"}},
        {"energies.dat", {5, "energy", "J"}},
        {"centreOfMass.dat", {6, "position", "m"}},
        {"extent.dat", {7, "position", "m"}},
        {"semiAxes.dat", {8, "semi-axis", "m"}},
        {"densityDeviation.dat", {9, "|rho/rho0 - 1|", ""}},
        {"particlesOutside.dat", {10, "particles", ""}},
    };
    const auto kind = kinds.find(file);
    return kind == kinds.end() ? Kind{11, fs::path(file).stem().string(), ""} : kind->second;
}

SampledFile::Column describe(const std::string& file, SampledFile::Column column)
{
    const Kind kind = kindOf(file);
    const auto startsWith = [&](const std::string& text) { return column.name.rfind(text, 0) == 0; };
    column.quantity = kind.quantity;
    column.unit = kind.unit;
    if (file == "height.dat")
    {
        column.usual = startsWith("hB");
        column.quantity = column.usual ? "level above the bottom" : "level above the location";
    }
    else if (file == "force.dat" || file == "moment.dat")
    {
        column.usual = startsWith("total_");
        if (startsWith("stops_"))
        {
            column.quantity = "impulse";
            column.unit += " s";
        }
    }
    else if (file == "energies.dat")
    {
        const std::vector<std::string> usual = {"kinetic", "potential", "internal", "work", "residual"};
        column.usual = std::find(usual.begin(), usual.end(), column.name) != usual.end();
    }
    else if (file == "centreOfMass.dat")
    {
        column.usual = column.name == "X" || column.name == "Y" || column.name == "Z";
        if (column.name == "u" || column.name == "v" || column.name == "w")
        {
            column.quantity = "velocity";
            column.unit = "m/s";
        }
    }
    else if (file == "particlesOutside.dat")
    {
        column.usual = column.name == "outside";
    }
    return column;
}

/// The lines before the first row; nothing where they name no times.
std::string headOf(const fs::path& file)
{
    std::ifstream in(file);
    std::string head;
    bool ofTime = false;
    for (std::string line; std::getline(in, line) && !line.empty() && line[0] == '#';)
    {
        head += line + "\n";
        ofTime = ofTime || std::regex_search(line, std::regex("^# *Time(\\s|$)"));
    }
    return ofTime && in ? head : "";
}

/// The columns that a head names. Of probes "# Probe 0 (x y z)" and "#  Probe  0  1", of gauges "# Location : (x y z)",
/// of all "# Time  name  prefix(a b c)".
std::vector<SampledFile::Column> columnsOf(const std::string& file, const std::string& head)
{
    std::vector<std::string> places, names;
    std::istringstream in(head);
    std::smatch match;
    for (std::string line; std::getline(in, line);)
    {
        if (std::regex_search(line, match, std::regex("^# (?:Probe [0-9]+|Location :) (\\(.*\\))")))
        {
            places.push_back(match[1]);
        }
        else if (std::regex_search(line, match, std::regex(file == "p" ? "^# *Probe\\s+(.*)" : "^# *Time\\s+(.*)")))
        {
            names.clear();
            const std::string list = match[1];
            const std::regex word("([^\\s()]*)\\(([^)]*)\\)|[^\\s()]+");
            for (std::sregex_iterator at(list.begin(), list.end(), word), end; at != end; ++at)
            {
                std::istringstream parts((*at)[2].matched ? (*at)[2].str() : at->str());
                for (std::string part; parts >> part;)
                {
                    names.push_back((*at)[1].str() + part);
                }
            }
        }
    }
    std::vector<SampledFile::Column> columns;
    for (std::size_t k = 0; k < names.size(); ++k)
    {
        const bool gauge = file == "height.dat", probe = file == "p";
        const std::size_t place = gauge ? k / 2 : k;
        SampledFile::Column column;
        column.number = static_cast<int>(k) + 1;
        column.name = probe ? "p" + names[k] : gauge ? names[k] + std::to_string(place) : names[k];
        column.place = (gauge || probe) && place < places.size() ? places[place] : "";
        columns.push_back(describe(file, column));
    }
    return columns;
}

bool isTime(const std::string& name, double& time)
{
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), time);
    return error == std::errc() && end == name.data() + name.size();
}

} // namespace

std::string SampledFile::name() const
{
    const std::string stem = fs::path(file).stem().string();
    return stem == "p" || stem == fs::path(function).filename() ? function : function + "/" + stem;
}

TimeSeries SampledFile::series(const Column& column) const
{
    return readTimeSeries(parts, column.number);
}

std::vector<SampledFile> findSampledFiles(const fs::path& postProcessing)
{
    std::map<std::pair<std::string, std::string>, std::map<double, fs::path>> found;
    std::error_code failure;
    fs::recursive_directory_iterator items(postProcessing, failure);
    for (; !failure && items != fs::recursive_directory_iterator(); items.increment(failure))
    {
        const std::string folder = items->path().filename().string();
        if (folder == "workPrecision" || folder == "sweep" || folder == "particles")
        {
            items.disable_recursion_pending(); // cases and clouds
        }
        double time = 0;
        const fs::path function = items->path().parent_path().parent_path().lexically_relative(postProcessing);
        if (items->is_regular_file(failure) && function != "." &&
            isTime(items->path().parent_path().filename().string(), time))
        {
            found[{function.string(), folder}][time] = items->path();
        }
    }
    std::vector<SampledFile> files;
    for (const auto& [name, parts] : found)
    {
        SampledFile sampled{name.first, name.second, {}, {}, false};
        const std::string head = headOf(parts.rbegin()->second);
        sampled.columns = columnsOf(sampled.file, head);
        for (const auto& part : parts)
        {
            const bool same = headOf(part.second) == head;
            sampled.changed = sampled.changed || !same;
            if (same)
            {
                sampled.parts.push_back(part.second);
            }
        }
        if (!sampled.columns.empty())
        {
            files.push_back(sampled);
        }
    }
    std::stable_sort(
        files.begin(), files.end(),
        [](const SampledFile& a, const SampledFile& b) { return kindOf(a.file).rank < kindOf(b.file).rank; }
    );
    return files;
}

} // namespace slosh
