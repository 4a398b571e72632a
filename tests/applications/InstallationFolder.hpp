// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseDirectory.hpp"

namespace slosh
{

/// A fresh folder with what `cmake --install` leaves in prefix/, removed with it.
class InstallationFolder
{
public:
    InstallationFolder();

    std::filesystem::path prefix() const { return folder_.path() / "prefix"; }

    /// What a script leaves behind that bash runs in the folder, with nothing of SloshSPH in its environment; it ends
    /// with the first command that fails.
    Ended bash(const std::string& script) const;

private:
    CaseDirectory folder_;
};

} // namespace slosh
