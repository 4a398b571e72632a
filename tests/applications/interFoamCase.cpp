// SPDX-License-Identifier: GPL-3.0-or-later
#include "interFoamCase.hpp"

#include "installed.hpp"

namespace slosh
{

namespace fs = std::filesystem;

fs::path interFoamCases()
{
    return "/usr/share/doc/openfoam-examples/examples/multiphase/interFoam/laminar";
}

std::string missingForInterFoamCases()
{
    std::string missing;
    for (const std::string program : {"blockMesh", "moveDynamicMesh", "m4", "perl", "gunzip"})
    {
        missing += isInstalled(program) ? "" : " " + program;
    }
    missing += fs::exists(interFoamCases()) ? "" : " " + interFoamCases().string();
    return missing.empty() ? "" : "NOT TESTED: missing are" + missing + " (packages openfoam, openfoam-examples, m4)";
}

InterFoamCase::InterFoamCase(const std::string& name)
{
    fs::remove_all(path());
    fs::copy(interFoamCases() / name, path(), fs::copy_options::recursive);
    if (fs::exists(path() / "system/blockMeshDict.m4.gz"))
    {
        succeedInShell(*this, "gunzip -c system/blockMeshDict.m4.gz | m4 > system/blockMeshDict");
    }
}

} // namespace slosh
