// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/TemporaryFolder.hpp"

#include "base/CaseError.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

namespace slosh
{

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder()
{
    std::string name = (fs::temp_directory_path() / "sloshsphXXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
    {
        throw CaseError("cannot make a folder in " + fs::temp_directory_path().string());
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code failure;
    fs::remove_all(path_, failure);
}

} // namespace slosh
