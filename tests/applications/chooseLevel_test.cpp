// SPDX-License-Identifier: GPL-3.0-or-later
// The program that starts a package's programs: scripts stand for those of the levels.
#include "CaseDirectory.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// bin/speak, a link to chooseLevel, in a fresh folder, with a script of the same name for each of `levels`.
void install(const CaseDirectory& folder, const std::vector<std::string>& levels)
{
    fs::create_directories(folder.path() / "bin");
    fs::create_directories(folder.path() / "lib");
    fs::copy_file(fs::path(SLOSH_BIN) / "chooseLevel", folder.path() / "lib/chooseLevel");
    fs::create_symlink("../lib/chooseLevel", folder.path() / "bin/speak");
    for (const std::string& level : levels)
    {
        fs::create_directories(folder.path() / "lib" / level);
        const std::string script = "lib/" + level + "/speak";
        folder.write(script, "#!/bin/sh\necho " + level + " \"$1\" \"$2\"\nexit 7\n");
        fs::permissions(folder.path() / script, fs::perms::owner_exec, fs::perm_options::add);
    }
}

/// Whether the processor has a level of the instruction set by the dynamic linker's own account.
bool processorHas(const CaseDirectory& folder, const std::string& level)
{
    return folder.run("/lib64/ld-linux-x86-64.so.2 --help").out.find(level + " (supported") != std::string::npos;
}

TEST(ChooseLevel, StartsTheHighestLevelThatTheProcessorHasAndPassesArgumentsAndStatusOn)
{
    const CaseDirectory folder;
    const bool v3 = processorHas(folder, "x86-64-v3"), v4 = processorHas(folder, "x86-64-v4");
    install(folder, {"x86-64", "x86-64-v3", "x86-64-v4"});
    const Ended all = folder.run("./bin/speak -case 'a b'", "env -u SLOSH_LEVEL");
    EXPECT_EQ(all.out, std::string(v4 ? "x86-64-v4" : v3 ? "x86-64-v3" : "x86-64") + " -case a b\n");
    EXPECT_EQ(all.status, 7);
    EXPECT_EQ(folder.run("./bin/speak", "SLOSH_LEVEL=x86-64").out, "x86-64  \n");

    fs::remove_all(folder.path() / "lib/x86-64-v4");
    EXPECT_EQ(folder.run("./bin/speak", "env -u SLOSH_LEVEL").out, std::string(v3 ? "x86-64-v3" : "x86-64") + "  \n");
    fs::remove_all(folder.path() / "lib/x86-64-v3");
    EXPECT_EQ(folder.run("./bin/speak", "env -u SLOSH_LEVEL").out, "x86-64  \n");
}

TEST(ChooseLevel, SaysWhatThereIsWhereALevelIsNotAndWhereThereIsNone)
{
    const CaseDirectory folder;
    install(folder, {"x86-64"});
    const Ended unknown = folder.run("./bin/speak", "SLOSH_LEVEL=avx9");
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(
        unknown.err.find("SLOSH_LEVEL is avx9; expected one that the processor and the package have: x86-64\n"),
        std::string::npos
    ) << unknown.err;

    fs::remove_all(folder.path() / "lib/x86-64");
    const Ended none = folder.run("./bin/speak");
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("there is no speak in the folders of"), std::string::npos) << none.err;
}

} // namespace
} // namespace slosh
