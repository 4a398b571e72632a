// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/motionTables.hpp"

#include "dictionary/Dictionary.hpp"
#include "dictionary/pathInCase.hpp"

namespace slosh
{

std::string tablePath(const std::string& name, const std::string& caseFolder)
{
    if (const auto inCase = pathInCase(name))
    {
        return caseFolder + "/" + *inCase;
    }
    return name.starts_with('/') ? name : caseFolder + "/" + name;
}

std::vector<std::string> motionTables(const Dictionary& dict, const std::string& caseFolder)
{
    std::vector<std::string> tables;
    for (const auto& key : dict.keys())
    {
        if (dict.isDict(key))
        {
            const auto inner = motionTables(dict.dict(key), caseFolder);
            tables.insert(tables.end(), inner.begin(), inner.end());
        }
        else if (key == "timeDataFileName" || key == "file")
        {
            tables.push_back(tablePath(dict.word(key), caseFolder));
        }
    }
    return tables;
}

} // namespace slosh
