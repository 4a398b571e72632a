// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ExtrudedTank.hpp"
#include "Turn.hpp"

#include "dictionary/Dictionary.hpp"

#include <optional>
#include <string>
#include <vector>

namespace slosh
{

/// The liquid at the start, as setFields would set it.
struct Liquid
{
    std::string field;                ///< "alpha.water", or "alpha1": the volume fraction that is set
    std::optional<double> level;      ///< z of the surface, where one box covers the tank up to it, [m]; else
    std::vector<BoundingBox> regions; ///< boxes inside the tank

    double depth(const ExtrudedTank& tank) const;  ///< its highest point above the tank's bottom, [m]
    double volume(const ExtrudedTank& tank) const; ///< [m^3]

    /// Reads system/setFieldsDict, whose boxes are turned: regions boxToCell, or zones of type box (OpenFOAM 11 and
    /// later), that set alpha.* or alpha1 (foam-extend, OpenFOAM before 2.3) to 1, or to 0 where there is no liquid.
    /// `warnings` says what is not used. Throws CaseError for regions of other kinds, volume fractions between 0 and 1,
    /// boxes that overlap or cross a slanted wall, and for no liquid at all.
    static Liquid read(
        const Dictionary& setFieldsDict, const Turn& turn, const ExtrudedTank& tank, std::vector<std::string>& warnings
    );
};

} // namespace slosh
