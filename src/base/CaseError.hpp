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
/// A message: where, what is wrong, what is expected:
///     constant/fluidProperties:19: rho0 is -998; expected a number > 0 [kg/m^3]
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

/// "constant/fluidProperties:19", or "constant/fluidProperties" for line 0: the place of an entry, with which messages
/// begin.
std::string placeIn(const std::string& file, int line);
/// "<place>: <message>", of something in a file.
CaseError errorIn(const std::string& place, const std::string& message);

/// The name among `valid` nearest to `word` (Damerau-Levenshtein distance, case ignored), or "" where none is within a
/// third of the word's length (2 edits are always allowed, 1 in a word of less than five letters).
std::string nearestName(const std::string& word, const std::vector<std::string>& valid);

/// "constant/kernelProperties:18: unknown kernel type 'gausian'; did you mean 'improvedGaussian'?\n
///  Valid kernel types: cubicSpline improvedGaussian quinticSpline taperedGaussian wendlandC2",
/// with `what` = "kernel type" and `place` = placeIn(...).
CaseError
unknownName(const std::string& what, const std::string& word, const std::string& place, std::vector<std::string> valid);

} // namespace slosh
