// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/DictionaryFiles.hpp"

#include "base/CaseError.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

bool isLeftOut(const std::string& name)
{
    static constexpr std::array leftOut{"constant/polyMesh/",  "system/fvSchemes",      "system/fvSolution",
                                        "system/comparisons",  "system/peakStatistics", "system/sweep",
                                        "system/workPrecision"};
    return std::any_of(
        leftOut.begin(), leftOut.end(), [&](const std::string& beginning) { return name.rfind(beginning, 0) == 0; }
    );
}

} // namespace

DictionaryFiles readDictionaryFiles(const fs::path& root)
{
    DictionaryFiles files;
    for (const std::string folder : {"constant", "system"})
    {
        if (!fs::is_directory(root / folder))
        {
            continue;
        }
        for (const auto& item : fs::recursive_directory_iterator(root / folder))
        {
            const std::string name = item.path().lexically_relative(root).generic_string();
            if (!item.is_regular_file() || isLeftOut(name))
            {
                continue;
            }
            std::ifstream in(item.path(), std::ios::binary);
            files[name].assign(std::istreambuf_iterator<char>(in), {});
            if (!in)
            {
                throw CaseError("cannot read " + item.path().string());
            }
        }
    }
    return files;
}

DictionaryFiles withEdits(DictionaryFiles files, const Edits& edits, const std::string& program)
{
    for (const auto& [file, entries] : edits)
    {
        files[file] += "\n// Set by " + program + "\n#inputMode merge\n" + entries + "\n";
    }
    return files;
}

} // namespace slosh
