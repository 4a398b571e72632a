// SPDX-License-Identifier: GPL-3.0-or-later
#include "InstallationFolder.hpp"

#include <cstdlib>
#include <stdexcept>

namespace slosh
{

InstallationFolder::InstallationFolder()
{
    const std::string install = "cmake --install '" SLOSH_BIN "/..' --prefix '" + prefix().string() + "' > /dev/null";
    if (std::system(install.c_str()) != 0)
    {
        throw std::runtime_error(install + " failed");
    }
}

Ended InstallationFolder::bash(const std::string& script) const
{
    folder_.write("script", "set -e\n" + script);
    return folder_.run(
        "./script", "env -i HOME=\"$PWD\" PATH=/usr/bin:/bin OMP_NUM_THREADS=1 "
                    "bash --norc"
    );
}

} // namespace slosh
