// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/writeSeries.hpp"

#include "base/writeFile.hpp"

#include <charconv>

namespace slosh
{

namespace
{

/// The shortest decimal text that reads back to the same bits.
std::string shortest(double value)
{
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

} // namespace

void writeSeries(const std::filesystem::path& file, const std::vector<SeriesFile>& files)
{
    std::string text = "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    for (std::size_t i = 0; i < files.size(); ++i)
    {
        text += i == 0 ? "\n" : ",\n";
        text += R"(    { "name" : ")" + files[i].name + R"(", "time" : )" + shortest(files[i].time) + " }";
    }
    writeFile(file, text + "\n  ]\n}\n");
}

} // namespace slosh
