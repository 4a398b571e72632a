// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Dictionary.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// An entry that a scheme sets where a case does not.
struct SchemeEntry
{
    std::string file; ///< "constant/kernelProperties"
    std::string path; ///< "kernel", "viscosity/type"
    std::string value;
    /// Another entry, which must have this value, in the case or by the scheme: "constant/kernelProperties" "kernel"
    /// "wendlandC2"; "" where it must be absent.
    struct Condition
    {
        std::string file, path, value;
    };
    std::vector<Condition> onlyWith{};
};

/// A scheme that is chosen whole, `scheme <name>;` in system/sphSchemes: kernel, dissipation, diffusion of density,
/// walls, integrator and step that go together. What the case says itself, in any of its files, goes before it.
struct NamedScheme
{
    std::string name;
    std::string sentence;
    std::vector<SchemeEntry> entries;
};

/// The first is what a case gets that names none.
const std::vector<NamedScheme>& namedSchemes();

/// `scheme` of system/sphSchemes.
Key schemeKey();

/// The one that `sphSchemes` names. Throws CaseError for an unknown name, with the nearest.
const NamedScheme& schemeNamedIn(const Dictionary& sphSchemes);

} // namespace slosh
