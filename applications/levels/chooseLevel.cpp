// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a package that holds each program once for every level of the x86-64 instruction set. It is started
// by the name of one of them (a link in bin/), and becomes the one of the highest level that this processor has:
//   <this folder>/<level>/<name>, level one of x86-64-v4 (AVX-512), x86-64-v3 (AVX2, FMA), x86-64 (any)
// The variable SLOSH_LEVEL asks for a level: bits are the same at any number of threads, not at any level.
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <unistd.h>

namespace
{

struct Level
{
    std::string name;
    bool supported;
};

int fail(const std::string& message)
{
    std::cerr << "--> FOAM FATAL ERROR:\n" << message << "\n";
    return 1;
}

} // namespace

int main(int, char** argv)
{
    // Of a level's instructions those that every compiler can ask for; no processor has them without the others.
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
    const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    const std::array levels = {Level{"x86-64-v4", v4}, Level{"x86-64-v3", v3}, Level{"x86-64", true}};
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    const std::string program = std::filesystem::path(argv[0]).filename();
    const char* const asked = std::getenv("SLOSH_LEVEL");
    std::string here; // the levels this processor has, of those installed
    for (const Level& level : levels)
    {
        const std::filesystem::path file = folder / level.name / program;
        if (!level.supported || !std::filesystem::exists(file))
        {
            continue;
        }
        if (asked == nullptr || level.name == asked)
        {
            execv(file.c_str(), argv);
            return fail("cannot start " + file.string() + ": " + std::strerror(errno));
        }
        here += " " + level.name;
    }
    if (here.empty())
    {
        return fail("there is no " + program + " in the folders of " + folder.string());
    }
    return fail(
        "SLOSH_LEVEL is " + std::string(asked) + "; expected one that the processor and the package have:" + here
    );
}
