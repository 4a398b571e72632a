// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace slosh
{

/// A file of samples, one row an instant, laid out as OpenFOAM lays out its function objects' files. Made when the
/// first row is written; every row reaches the disk at once, so that a run can be watched. Throws CaseError where that
/// fails.
class SampleFile
{
public:
    SampleFile(std::filesystem::path file, std::string header, int precision);

    void beginRow(double time);
    void add(double value);       ///< 14 columns
    void add(const Vec& value);   ///< "             (x y z)"
    void addTabbed(double value); ///< a tab and the value, as in interfaceHeight's and forces' files
    void addTabbed(const Vec& value);
    void endRow();

    const std::filesystem::path& path() const { return file_; }
    bool written() const { return out_.is_open(); }

private:
    std::string text(double value) const;

    std::filesystem::path file_;
    std::string header_;
    int precision_;
    std::ofstream out_;
    std::string row_;
};

/// `text` in columns that end where OpenFOAM ends them: "#" and 12 columns for the time, 14 for every value.
std::string sampleColumn(std::string_view text);
std::string timeColumn(std::string_view text);

} // namespace slosh
