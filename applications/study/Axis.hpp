// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/DictionaryFiles.hpp"

#include "dictionary/Dictionary.hpp"

#include <optional>
#include <string>
#include <vector>

namespace slosh
{

/// What is varied: an entry of a dictionary that takes some values, or named sets of entries.
struct Axis
{
    struct Value
    {
        std::string label; ///< names it in runs and tables
        Edits edits;
    };

    std::string name;
    bool isSpacing = false; ///< the particleSpacing of system/blockParticlesDict: what orders are observed over
    bool isMember = false;  ///< its values are the members of an ensemble: each as good an answer as the others
    std::vector<Value> values;
    std::string file, entry;      ///< that takes the values; empty with settings
    std::optional<Vec> direction; ///< the entry is a vector: the value times this

    /// What gives the entry this value. `value` is a number where there is a direction.
    Edits editsFor(const std::string& value) const;

    /// The place of a label among the values. Throws CaseError: none of that name; `place` as in unknownName.
    std::size_t indexOf(const std::string& label, const std::string& place) const;
};

/// The entries of an axis: an entry of a file with `values`, or with `range` and `count`, or `settings` alone. Examples
/// are the program's.
namespace axisEntries
{

inline constexpr Key file{.name = "file", .sentence = "any file of the case"};
inline constexpr Key entry{.name = "entry", .sentence = "any entry of the file; dots separate sub-dictionaries"};
inline constexpr Key direction{
    .name = "direction",
    .leftOut = "none",
    .example = "(1 0 0)",
    .sentence = "the entry is a vector, value times direction; without direction it is the value"};
inline constexpr Key values{.name = "values", .sentence = "words or numbers"};
inline constexpr Key range{.name = "range", .sentence = "instead of values: from, to"};
inline constexpr Key count{
    .name = "count", .range = between(2, 1000), .sentence = "number of equally spaced values of range"};
inline constexpr Key settings{
    .name = "settings",
    .sentence = "for values of several entries: named sets of entries by file, appended to the files and merged with "
                "their entries; #remove deletes an entry"};

inline constexpr Key mls{
    .name = "mls",
    .example = R"("system/sphSchemes" { densityReinitialisation { type MLS; interval 20; } })",
    .entries = noKeys,
    .anyName = true}; ///< one of `settings`

} // namespace axisEntries

/// Reads the sub-dictionary of one axis. `files` are those of the case, among which every file named must be. Throws
/// CaseError.
Axis readAxis(const Dictionary& dict, const std::string& name, const DictionaryFiles& files);

} // namespace slosh
