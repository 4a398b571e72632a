// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/pathInCase.hpp"

#include <array>
#include <utility>

namespace slosh
{

namespace fs = std::filesystem;

std::optional<std::string> pathInCase(const std::string& path)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> beginnings = {
        {{"$FOAM_CASE", ""},
         {"${FOAM_CASE}", ""},
         {"<case>", ""},
         {"<constant>", "constant/"},
         {"<system>", "system/"}}};
    for (const auto& [beginning, folder] : beginnings)
    {
        if (path.starts_with(beginning))
        {
            const std::size_t rest = path.find_first_not_of('/', beginning.size());
            return std::string(folder) + (rest == std::string::npos ? "" : path.substr(rest));
        }
    }
    return std::nullopt;
}

fs::path caseOf(const fs::path& folder)
{
    fs::path whole = fs::absolute(folder / ".").lexically_normal().parent_path(); // without the '/' at its end
    for (fs::path part = whole; part.has_relative_path(); part = part.parent_path())
    {
        if (part.filename() == "constant" || part.filename() == "system")
        {
            return part.parent_path();
        }
    }
    return whole.parent_path();
}

} // namespace slosh
