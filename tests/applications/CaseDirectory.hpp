// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace slosh
{

/// What a program left behind when it ended.
struct Ended
{
    int status = 0; ///< exit status, as a shell sees it
    std::string out, err;
};

/// A fresh case directory for one test, removed with it: a small rolling tank in the yz plane, 0.2 m x 0.15 m, liquid
/// 0.1 m deep, 20 x 10 particles, 0.1 s.
class CaseDirectory
{
public:
    CaseDirectory();
    ~CaseDirectory();
    CaseDirectory(const CaseDirectory&) = delete;
    CaseDirectory& operator=(const CaseDirectory&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // The files of the case, named relative to it.
    std::string text(const std::string& file) const;
    void write(const std::string& file, const std::string& text) const;
    void remove(const std::string& fileOrFolder) const;
    /// Replaces the one occurrence of `from`; a test that edits nothing fails.
    void edit(const std::string& file, const std::string& from, const std::string& to) const;
    /// Every file and its content.
    std::map<std::string, std::string> tree() const;
    /// Copies all of another case into this one.
    void copyFrom(const CaseDirectory& other) const;

    /// Runs `blockParticles -threads 2` or the like in the case, as a shell would, or `./program` of the case itself,
    /// or one by its whole path;
    /// `before` stands before the program's path ("ulimit -f 8;").
    Ended run(const std::string& command, const std::string& before = "") const;
    /// The same; a test fails that expects it to succeed and it does not.
    std::string succeed(const std::string& command) const;

private:
    std::filesystem::path path_;
};

} // namespace slosh
