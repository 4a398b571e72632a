// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/CaseError.hpp"
#include "base/Vec.hpp"
#include "dictionary/Key.hpp"
#include "dictionary/Range.hpp"
#include "dictionary/Token.hpp"
#include "dictionary/Unit.hpp"

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slosh
{

/// A dictionary in OpenFOAM's syntax: entries `keyword tokens ;` and `keyword { ... }`, each with
/// its file and line. Macros, #include, #inputMode, #eval/#calc and regular-expression keys are resolved when it is
/// read.
///
/// Every read states unit and range, so that a wrong value is refused where it stands:
///     constant/fluidProperties:19: rho0 is -998; expected a number > 0 [kg/m^3]
/// Reads are remembered: after a part of the program has read all it knows, refuseUnknown() throws for an entry nobody
/// asked for (with the nearest name asked for), and unusedEntries() lists those that were allow()ed but not read.
/// A Dictionary is a cheap handle: copies share entries and what was read.
class Dictionary
{
public:
    /// An empty dictionary, for writing.
    explicit Dictionary(std::string name);

    /// Reads a file; `name` is how messages call it ("system/controlDict"). Throws CaseError (missing file, syntax).
    static Dictionary read(const std::filesystem::path& file, const std::string& name);
    /// Parses text; #include is relative to `folder`.
    static Dictionary parse(std::string_view text, const std::string& name, const std::filesystem::path& folder = ".");

    const std::string& name() const;       ///< file, and the path inside: "constant/tankProperties/geometry/baffle"
    int line() const;                      ///< where it begins, 0 for a file
    std::vector<std::string> keys() const; ///< in the order of the file, FoamFile left out
    bool has(std::string_view key) const;  ///< literal or regular-expression key; counts as asked for
    bool isDict(std::string_view key) const;

    // Typed reads. A missing key throws in OpenFOAM's words:
    //   system/controlDict: entry 'deltaT' not found in dictionary "system/controlDict" (lines 1 to 31)
    // Dimensioned entries `rho0 [1 -3 0 0 0 0 0] 998;` and the old form `rho0 rho0 [..] 998;` are checked against the
    // unit; without dimensions the value is taken in that unit.
    double scalar(std::string_view key, const Unit& unit, const Range& range = anyNumber) const;
    double scalarOr(std::string_view key, double otherwise, const Unit& unit, const Range& range = anyNumber) const;
    long label(std::string_view key, const Range& range = anyNumber) const; ///< a whole number
    long labelOr(std::string_view key, long otherwise, const Range& range = anyNumber) const;
    bool flag(std::string_view key) const;        ///< yes no on off true false
    std::string word(std::string_view key) const; ///< a word, a quoted string, a path `a / b` as OpenFOAM writes it
    std::string wordOr(std::string_view key, const std::string& otherwise) const;
    /// A word out of a list; `what` names the kind in messages ("kernel type").
    std::string choice(std::string_view key, const std::vector<std::string>& valid, const std::string& what) const;
    Vec vector(std::string_view key, const Unit& unit) const; ///< (x y z), finite
    std::vector<double> scalars(std::string_view key, const Unit& unit, const Range& range = anyNumber) const;
    std::vector<Vec> vectors(std::string_view key, const Unit& unit) const; ///< ((x y z) ...), with or without a count
    std::vector<Vec2> planePoints(std::string_view key, const Unit& unit) const; ///< ((a b) ...), likewise
    std::vector<std::string> words(std::string_view key) const;                  ///< (p U)
    const std::vector<Token>& tokens(std::string_view key) const;                ///< the entry's raw tokens

    // The same of an entry that is declared as data: in its unit and range; where it is left out its `otherwise`.
    double scalar(const Key& key) const;
    long label(const Key& key) const;
    bool flag(const Key& key) const;
    std::string word(const Key& key) const;
    std::string choice(const Key& key, const std::string& what) const; ///< one of the key's options
    Vec vector(const Key& key) const;
    std::vector<double> scalars(const Key& key) const;
    std::vector<Vec> vectors(const Key& key) const;
    std::vector<Vec2> planePoints(const Key& key) const;
    std::vector<std::string> words(const Key& key) const;
    // Where the default is not known before the program runs:
    double scalarOr(const Key& key, double otherwise) const { return has(key) ? scalar(key) : otherwise; }
    long labelOr(const Key& key, long otherwise) const { return has(key) ? label(key) : otherwise; }
    std::string wordOr(const Key& key, const std::string& otherwise) const { return has(key) ? word(key) : otherwise; }

    /// An entry that is dimensions alone, `dimensions [0 1 -2 0 0 0 0];`: they must be those of `unit`.
    void requireDimensions(std::string_view key, const Unit& unit) const;

    Dictionary dict(std::string_view key) const; ///< a sub-dictionary, or throws
    /// A sub-dictionary; an empty one named like it where there is none.
    Dictionary dictOr(std::string_view key) const;

    /// Names keys that are valid here though this run may not read them.
    void allow(const std::vector<std::string>& keys) const;
    /// Names keys that other programs read: never unknown, never reported as unused.
    void ignore(const std::vector<std::string>& keys) const;
    /// Throws for the first entry (of this level) that was neither read nor allowed, nor is what a macro stands for;
    /// sub-dictionaries look after themselves.
    void refuseUnknown() const;
    /// The same where all that may stand here is declared: `keys` and those of their options, which a run need not
    /// read. Throws std::logic_error where one was asked for that is not declared.
    void refuseUnknown(const Keys& keys) const;
    /// The same, and entries of options that the dictionary does not take are unknown, too.
    void refuseIdle(const Keys& keys) const;
    /// Allowed entries (this level and below) that were never read:
    /// "system/controlDict:31: maxCo".
    std::vector<std::string> unusedEntries() const;

    /// The files its entries stand in, as messages call them, those it includes among them.
    std::set<std::string> files() const;

    /// "constant/fluidProperties:19: rho0 <message>": an error at an entry, to be thrown by the caller.
    CaseError errorAt(std::string_view key, const std::string& message) const;
    /// "constant/fluidProperties:19", for messages composed elsewhere (errorIn in base/CaseError.hpp); `key` may lead
    /// into sub-dictionaries, "viscosity/type".
    std::string placeOf(std::string_view key) const;
    /// The tokens of an entry as text, "" where there is none: for a log. Does not count as a read. `path` as in
    /// setDefault.
    std::string textAt(std::string_view path) const;

    /// Sets an entry that is not there: `path` may lead into sub-dictionaries, "viscosity/type". Messages call where it
    /// stands `origin`; it is never unknown, nor reported as unused. Whether it was set.
    bool setDefault(std::string_view path, std::string_view value, const std::string& origin);
    bool isDefault(std::string_view path) const; ///< whether setDefault() set it

    // Writing
    void set(std::string_view key, std::string_view value); ///< value: any tokens as text; replaces or appends
    void set(std::string_view key, double value);           ///< 17 digits: reads back to the same bits
    void set(std::string_view key, long value);
    void set(std::string_view key, const Vec& value);
    void set(std::string_view key, const Dictionary& value);
    /// The entries in OpenFOAM's layout, without a FoamFile header; before them #remove of what was removed.
    std::string text() const;

    struct Node; ///< DictionaryNode.hpp
    struct Entry;

private:
    explicit Dictionary(std::shared_ptr<Node> node);
    const Entry& entry(std::string_view key) const; ///< or throws
    std::shared_ptr<Node> node_;
};

} // namespace slosh
