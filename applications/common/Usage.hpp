// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/AnnotatedDictionary.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// All that is said of a program's command line, once: -help, the manual page and the completion are made of it.
struct Usage
{
    struct Row
    {
        std::string name; ///< without the dash of an option
        std::string what; ///< an option's argument, "dir", or its words, "vtu|csv"; empty: it has none
        std::string description;
    };

    std::string name;
    std::string purpose; ///< one line
    std::string example; ///< a command line
    std::vector<Row> options, files, variables;

    /// Those of a case that it reads: -help-dict shows them.
    std::vector<AnnotatedDictionary> dictionaries;

    /// What an entry can name.
    struct Choices
    {
        std::string entry; ///< "kernel in constant/kernelProperties"
        std::vector<Row> names;
    };
    std::vector<Choices> choices;

    /// What -help prints; etc/completion.bash.in reads its options.
    std::string help() const;
    /// The manual page, section 1, in the language of roff (macros man).
    std::string manPage() const;
    /// The annotated dictionary of that path. Throws CaseError where the program has none, with those that it has.
    std::string annotated(const std::string& path) const;
};

} // namespace slosh
