// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FieldValues.hpp"
#include "base/Vec.hpp"
#include "case/Controls.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slosh
{

/// OpenFOAM's banner and FoamFile header: version 2.0, format, class, location, object; arch "LSB;label=32;scalar=64"
/// where binary.
std::string foamHeader(
    const std::string& className, const std::string& location, const std::string& object,
    WriteFormat format = WriteFormat::ascii
);

// Lagrangian fields as OpenFOAM writes them (class scalarField, vectorField, labelField): N, then the values in
// parentheses, ascii one a line, binary raw. Written whole or not at all. `location` is "0.5/lagrangian/fluid".
void writeField(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    std::span<const double> values, const WriteOptions& options
);
void writeField(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    std::span<const Vec> values, const WriteOptions& options
);
void writeField(
    const std::filesystem::path& root, const std::string& location, const std::string& object,
    std::span<const int> values, const WriteOptions& options
);
/// class Cloud<passiveParticle>: N ( (x y z) cell ... ), every cell label 0.
void writePositions(
    const std::filesystem::path& root, const std::string& location, std::span<const Vec> positions,
    const WriteOptions& options
);

// Readers for both formats and uniform fields N{v}; scalar=32 where declared. `expected`: how many values there must be
// (a field of another length is refused), -1 for any. Throw CaseError naming the file (and, in ascii, the line):
// missing, not of this class, truncated, a value that is NaN or infinite (with its index).
std::vector<double> readScalarField(const std::filesystem::path& root, const std::string& file, long expected = -1);
std::vector<Vec> readVectorField(const std::filesystem::path& root, const std::string& file, long expected = -1);
std::vector<int> readLabelField(const std::filesystem::path& root, const std::string& file, long expected = -1);
/// A field of any of these classes; none of a file that is not one.
std::optional<FieldValues> readFieldIfOne(const std::filesystem::path& root, const std::string& file, long expected);
std::vector<Vec> readPositions(const std::filesystem::path& root, const std::string& file);

} // namespace slosh
