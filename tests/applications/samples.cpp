// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples.hpp"

#include <sstream>

namespace slosh
{

std::vector<std::vector<double>> rowsOf(const std::string& text)
{
    std::vector<std::vector<double>> rows;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
    {
        if (line.empty() || line[0] == '#')
        {
            continue;
        }
        for (char& c : line)
        {
            c = c == '(' || c == ')' ? ' ' : c;
        }
        std::istringstream numbers(line);
        rows.emplace_back();
        for (double x; numbers >> x;)
        {
            rows.back().push_back(x);
        }
    }
    return rows;
}

std::string samplesOf(const std::string& text)
{
    std::istringstream in(text);
    std::string samples;
    for (std::string line; std::getline(in, line);)
    {
        samples += line.empty() || line[0] == '#' ? "" : line + "\n";
    }
    return samples;
}

} // namespace slosh
