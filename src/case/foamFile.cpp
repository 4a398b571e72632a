// SPDX-License-Identifier: GPL-3.0-or-later
// Writing; reading is in readFoamFile.cpp.
#include "case/foamFile.hpp"

#include "base/writeFile.hpp"

#include <charconv>
#include <cstdint>
#include <cstring>

namespace slosh
{

namespace
{

void append(std::string& out, double x, int precision)
{
    char digits[40];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, x, std::chars_format::general, precision).ptr);
}

void append(std::string& out, const Vec& x, int precision)
{
    out += '(';
    append(out, x[0], precision);
    out += ' ';
    append(out, x[1], precision);
    out += ' ';
    append(out, x[2], precision);
    out += ')';
}

void append(std::string& out, int x, int)
{
    char digits[16];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

template <class T>
void writeList(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    const std::string& className, std::span<const T> values, const WriteOptions& options
)
{
    std::string out = foamHeader(className, location, object, options.format);
    out += "\n" + std::to_string(values.size()) + "\n(";
    if (options.format == WriteFormat::binary)
    {
        out.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    else
    {
        out += '\n';
        for (const T& value : values)
        {
            append(out, value, options.precision);
            out += '\n';
        }
    }
    out += ")\n";
    writeFile(root / location / object, out);
}

} // namespace

std::string
foamHeader(const std::string& className, const std::string& location, const std::string& object, WriteFormat format)
{
    const bool binary = format == WriteFormat::binary;
    std::string out = "/*--------------------------------*- C++ -*----------------------------------*\\\n"
                      "| SloshSPH: smoothed particle hydrodynamics of liquid sloshing in moving tanks |\n"
                      "\\*---------------------------------------------------------------------------*/\n"
                      "FoamFile\n{\n    version     2.0;\n";
    out += std::string("    format      ") + (binary ? "binary" : "ascii") + ";\n";
    if (binary)
    {
        out += "    arch        \"LSB;label=32;scalar=64\";\n";
    }
    out += "    class       " + className + ";\n";
    if (!location.empty())
    {
        out += "    location    \"" + location + "\";\n";
    }
    out += "    object      " + object + ";\n}\n";
    return out;
}

void writeField(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    std::span<const double> values, const WriteOptions& options
)
{
    writeList(root, location, object, "scalarField", values, options);
}

void writeField(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    std::span<const Vec> values, const WriteOptions& options
)
{
    static_assert(sizeof(Vec) == 3 * sizeof(double));
    writeList(root, location, object, "vectorField", values, options);
}

void writeField(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    std::span<const int> values, const WriteOptions& options
)
{
    static_assert(sizeof(int) == 4);
    writeList(root, location, object, "labelField", values, options);
}

void writePositions(
    const std::filesystem::path& root, const std::string& location, std::span<const Vec> positions,
    const WriteOptions& options
)
{
    std::string out = foamHeader("Cloud<passiveParticle>", location, "positions", options.format);
    out += "\n" + std::to_string(positions.size()) + "\n(\n";
    for (const Vec& x : positions)
    {
        if (options.format == WriteFormat::binary)
        {
            const std::int32_t cell = 0;
            char bytes[3 * sizeof(double) + sizeof cell];
            std::memcpy(bytes, x.data(), 3 * sizeof(double));
            std::memcpy(bytes + 3 * sizeof(double), &cell, sizeof cell);
            out += '(';
            out.append(bytes, sizeof bytes);
            out += ")\n";
        }
        else
        {
            append(out, x, options.precision);
            out += " 0\n";
        }
    }
    out += ")\n";
    writeFile(root / location / "positions", out);
}

} // namespace slosh
