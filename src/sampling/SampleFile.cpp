// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/SampleFile.hpp"

#include "base/CaseError.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>

namespace slosh
{

namespace
{

std::string rightAligned(std::string_view text, std::size_t width)
{
    return std::string(text.size() < width ? width - text.size() : 0, ' ') + std::string(text);
}

} // namespace

std::string sampleColumn(std::string_view text)
{
    return " " + rightAligned(text, 13);
}

std::string timeColumn(std::string_view text)
{
    return "#" + rightAligned(text, 12);
}

SampleFile::SampleFile(std::filesystem::path file, std::string header, int precision)
    : file_(std::move(file)), header_(std::move(header)), precision_(precision)
{
}

std::string SampleFile::text(double value) const
{
    char digits[40];
    return std::string(
        digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, precision_).ptr
    );
}

void SampleFile::beginRow(double time)
{
    // Ten digits tell the steps of any run apart and end at column 13.
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, time, std::chars_format::general, 10).ptr;
    row_ = rightAligned(std::string_view(digits, static_cast<std::size_t>(end - digits)), 13);
}

void SampleFile::add(double value)
{
    row_ += sampleColumn(text(value));
}

void SampleFile::add(const Vec& value)
{
    row_ += "             (" + text(value[0]) + " " + text(value[1]) + " " + text(value[2]) + ")";
}

void SampleFile::addTabbed(double value)
{
    row_ += "\t" + text(value);
}

void SampleFile::addTabbed(const Vec& value)
{
    row_ += "\t(" + text(value[0]) + " " + text(value[1]) + " " + text(value[2]) + ")";
}

void SampleFile::endRow()
{
    errno = 0;
    if (!out_.is_open())
    {
        std::error_code failure;
        std::filesystem::create_directories(file_.parent_path(), failure);
        if (failure)
        {
            throw CaseError("cannot make the directory " + file_.parent_path().string() + ": " + failure.message());
        }
        out_.open(file_, std::ios::binary | std::ios::trunc);
        out_ << header_;
    }
    out_ << row_ << "\n" << std::flush;
    if (!out_)
    {
        throw CaseError(
            "cannot write " + file_.string() + (errno != 0 ? std::string(": ") + std::strerror(errno) : "")
        );
    }
}

} // namespace slosh
