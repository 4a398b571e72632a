// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace slosh
{

/// What the user can mend: a wrong entry, a missing file, a run that became unphysical. The only exception type the
/// programs catch in main, where text() goes to stderr and the exit status becomes 1.
///
/// A message: where, what is wrong, what is expected: "'rho0' is -998 in constant/fluidProperties at line 19; it must
/// be a number > 0, in kg/m^3".
class CaseError : public std::runtime_error
{
public:
    /// What is wrong: something in a file (OpenFOAM's FATAL IO ERROR), or anything else.
    enum class Kind
    {
        general,
        input
    };

    explicit CaseError(const std::string& message, Kind kind = Kind::general) : std::runtime_error(message), kind_(kind)
    {
    }

    Kind kind() const { return kind_; }
    /// The message under OpenFOAM's headline: "--> FOAM FATAL ERROR:\n<message>\n", or FATAL IO ERROR.
    std::string text() const;

private:
    Kind kind_;
};

/// " in constant/fluidProperties at line 19", or " in constant/fluidProperties" for line 0: the place of an entry in a
/// message.
std::string atPlace(const std::string& file, int line);

/// The name among `valid` nearest to `word` (Damerau-Levenshtein distance, case ignored), or "" where none is within a
/// third of the word's length (2 edits are always allowed, 1 in a word of less than five letters).
std::string nearestName(const std::string& word, const std::vector<std::string>& valid);

/// "Unknown kernel type 'gausian' in constant/kernelProperties at line 18; did you mean 'improvedGaussian'?\n
///  Valid kernel types: cubicSpline improvedGaussian quinticSpline taperedGaussian wendlandC2",
/// with `what` = "kernel type" and `place` = atPlace(...).
CaseError
unknownName(const std::string& what, const std::string& word, const std::string& place, std::vector<std::string> valid);

} // namespace slosh
