// SPDX-License-Identifier: GPL-3.0-or-later
#include "dictionary/readText.hpp"

#include "base/CaseError.hpp"

#include <zlib.h>

#include <array>
#include <fstream>
#include <sstream>

namespace slosh
{

namespace fs = std::filesystem;

namespace
{

std::string readCompressed(const fs::path& file, const std::string& name)
{
    std::string text;
    const gzFile in = gzopen(file.c_str(), "rb");
    int length = -1;
    if (in != nullptr)
    {
        for (std::array<char, 65536> part{}; (length = gzread(in, part.data(), part.size())) > 0;)
        {
            text.append(part.data(), static_cast<std::size_t>(length));
        }
    }
    // Only closing says of a file that it was cut off.
    if (in == nullptr || gzclose(in) != Z_OK || length != 0)
    {
        throw CaseError(name + ".gz: cannot read the file", CaseError::Kind::input);
    }
    return text;
}

} // namespace

bool isThere(const fs::path& file)
{
    std::error_code failure;
    return fs::exists(file, failure) || fs::exists(file.string() + ".gz", failure);
}

std::string readText(const fs::path& file, const std::string& name)
{
    std::error_code failure;
    if (!fs::is_regular_file(file, failure))
    {
        if (const fs::path compressed = file.string() + ".gz"; fs::is_regular_file(compressed, failure))
        {
            return readCompressed(compressed, name);
        }
        throw CaseError(name + ": file not found", CaseError::Kind::input);
    }
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
    {
        throw CaseError(name + ": cannot read the file", CaseError::Kind::input);
    }
    return std::move(text).str();
}

} // namespace slosh
