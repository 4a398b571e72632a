// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/writeFile.hpp"

#include "base/CaseError.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace slosh
{

void writeFile(const std::filesystem::path& file, std::string_view content)
{
    std::error_code failure;
    if (file.has_parent_path())
    {
        std::filesystem::create_directories(file.parent_path(), failure);
        if (failure)
        {
            throw CaseError("cannot make the directory " + file.parent_path().string() + ": " + failure.message());
        }
    }
    std::filesystem::path temporary = file;
    temporary += ".tmp";

    std::FILE* out = std::fopen(temporary.c_str(), "wb");
    int reason = out ? 0 : errno;
    if (out)
    {
        errno = 0;
        const bool written = std::fwrite(content.data(), 1, content.size(), out) == content.size();
        const bool flushed = std::fflush(out) == 0;
        reason = written && flushed ? 0 : (errno ? errno : EIO);
        if (std::fclose(out) != 0 && reason == 0)
        {
            reason = errno;
        }
    }
    if (reason == 0)
    {
        std::filesystem::rename(temporary, file, failure);
        reason = failure.value();
    }
    if (reason != 0)
    {
        std::filesystem::remove(temporary, failure);
        throw CaseError("cannot write " + file.string() + ": " + std::strerror(reason));
    }
}

} // namespace slosh
