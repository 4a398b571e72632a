// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseDirectory.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// An interFoam case in a few lines: a box of 2 m x 1 m x 1 m from (-1 -0.5 0), half full, at rest, without functions.
class InterFoamBox : public CaseDirectory
{
public:
    InterFoamBox();

    /// Of `foamToSlosh -to ours -spacing 0.1`, which succeeds.
    std::string converted() const;
    /// What it says, on both channels, where it is refused; nothing may be written.
    Ended refused() const;
};

/// A test fails for each of `words` that `text` does not have.
void expectHas(const std::string& text, const std::vector<std::string>& words);

} // namespace slosh
