// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/namedSchemes.hpp"
#include "dictionary/Dictionary.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace slosh
{

/// A time directory: its name as it stands on disk and its value, [s].
struct TimeDirectory
{
    std::string name;
    double value = 0;
};

/// A case directory: where its dictionaries and time directories are.
class Case
{
public:
    /// Throws CaseError "cannot open case directory <path>" where it is none.
    explicit Case(const std::filesystem::path& root);

    const std::filesystem::path& root() const { return root_; }
    std::string name() const; ///< the directory's own name, for VTK files and <name>.foam

    /// constant/..., system/...: named as given in messages, with the entries of the case's scheme that it does not set
    /// itself (namedSchemes.hpp). Throws CaseError where it is missing or malformed.
    Dictionary dictionary(const std::string& file) const;
    /// The same, or one that has only the scheme's entries where the file is missing.
    Dictionary dictionaryIfPresent(const std::string& file) const;

    /// The scheme's parts with the values of this case and where each stands: "viscosity/alpha 0.03
    /// (constant/fluidProperties:24)", "kernel wendlandC2 (scheme recommended)".
    std::vector<std::string> schemeParts() const;
    const NamedScheme& scheme() const;

    /// Entries of the dictionaries read so far that were allowed but not needed: "system/controlDict:31: maxCo".
    std::vector<std::string> unusedEntries() const;

    /// Directories whose name is a number and that hold lagrangian/, sorted by value.
    std::vector<TimeDirectory> times() const;

    /// constant/g, [m/s^2].
    Vec gravity() const;

    /// Removes a time directory, as purgeWrite does.
    void removeTime(const std::string& name) const;

private:
    /// The file's entries, or none, and the scheme's.
    Dictionary completed(const std::string& file) const;

    std::filesystem::path root_;
    mutable std::vector<Dictionary> read_; ///< handles, for unusedEntries()
};

/// All entries of constant/g.
Keys gravityKeys();

} // namespace slosh
