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
    std::vector<Value> values;
    std::string file, entry;      ///< that takes the values; empty with settings
    std::optional<Vec> direction; ///< the entry is a vector: the value times this

    /// What gives the entry this value. `value` is a number where there is a direction.
    Edits editsFor(const std::string& value) const;

    /// The place of a label among the values. Throws CaseError: none of that name; `place` as in unknownName.
    std::size_t indexOf(const std::string& label, const std::string& place) const;
};

/// Reads the sub-dictionary of one axis:
///     { file "constant/fluidProperties"; entry viscosity.alpha; values (0.03 0.01 0); } // dots lead into dictionaries
///     { file ...; entry ...; range (0.6 1.4); count 9; }              // from, to, how many at equal distances
///     { file ...; entry ...; direction (1 0 0); values (2 4 8); }     // the entry is a vector: the value times this
///     { settings                                                      // or, where a value is more than one entry
///       {
///           plain { }
///           mls   { "system/sphSchemes" { densityReinitialisation { type MLS; interval 20; } } }
///       } }
/// `files` are those of the case, among which every file named must be. Throws CaseError.
Axis readAxis(const Dictionary& dict, const std::string& name, const DictionaryFiles& files);

} // namespace slosh
