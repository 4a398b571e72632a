// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/motionTables.hpp"

#include "dictionary/Dictionary.hpp"

namespace slosh
{

std::string tablePath(const std::string& name, const std::string& caseFolder)
{
    for (const auto& [variable, folder] :
         {std::pair<std::string, std::string>("$FOAM_CASE", ""),
          {"${FOAM_CASE}", ""},
          {"<case>", ""},
          {"<constant>", "/constant"},
          {"<system>", "/system"}})
    {
        if (name.rfind(variable, 0) == 0)
        {
            return caseFolder + folder + name.substr(variable.size());
        }
    }
    return name.rfind('/', 0) == 0 ? name : caseFolder + "/" + name;
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
        else if (key == "timeDataFileName")
        {
            tables.push_back(tablePath(dict.word(key), caseFolder));
        }
    }
    return tables;
}

} // namespace slosh
