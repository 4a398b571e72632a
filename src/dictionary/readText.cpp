#include "base/CaseError.hpp"
#include "dictionary/parse.hpp"

#include <fstream>
#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

std::string readText(const fs::path& file, const std::string& name)
{
    std::error_code failure;
    if (!fs::is_regular_file(file, failure))
    {
        throw CaseError("cannot find file \"" + name + "\"", CaseError::Kind::input);
    }
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
    {
        throw CaseError("cannot read file \"" + name + "\"", CaseError::Kind::input);
    }
    return std::move(text).str();
}

} // namespace slosh
