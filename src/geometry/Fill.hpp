// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "geometry/Shape.hpp"

namespace slosh
{

class Dictionary;

/// Where the liquid is at the start, as constant/tankProperties says.
class Fill
{
public:
    /// `tank`: its walls; `bodies`: those in it, which liquid goes around. Throws CaseError: two fills or none, a
    /// level above the roof or below the bottom, a region outside the tank, regions that overlap.
    static Fill read(const Dictionary& tankProperties, const Shape& tank, const Shapes& bodies);

    double level() const { return level_; }   ///< z of the highest point of the liquid, [m]
    double volume() const { return volume_; } ///< outside the bodies, [m^3]
    /// The tank is filled from wall to wall: its still surface is that of its natural frequencies.
    bool fromWallToWall() const { return regions_.empty(); }
    /// Every part of the liquid has its surface at level(): pressure can be hydrostatic throughout.
    bool hasOneSurface() const;
    bool contains(const Vec& X) const { return depthAt(X) > 0; }
    /// Below the surface of the region X is in, [m]; 0 outside the liquid. A sphere is a drop: its depth is that below
    /// its own top.
    double depthAt(const Vec& X) const;

private:
    double level_ = 0;
    double volume_ = 0;
    Shapes regions_; ///< none: all below level_
};

/// Its entries of constant/tankProperties, of which one is given.
Keys fillKeys();

} // namespace slosh
