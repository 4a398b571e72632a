// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/writeSeries.hpp"

#include "base/numberText.hpp"
#include "base/writeFile.hpp"

namespace slosh
{

void writeSeries(const std::filesystem::path& file, const std::vector<SeriesFile>& files)
{
    std::string text = "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    for (std::size_t i = 0; i < files.size(); ++i)
    {
        text += i == 0 ? "\n" : ",\n";
        text += R"(    { "name" : ")" + files[i].name + R"(", "time" : )" + numberText(files[i].time) + " }";
    }
    writeFile(file, text + "\n  ]\n}\n");
}

} // namespace slosh
