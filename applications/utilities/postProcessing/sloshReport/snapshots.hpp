// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "geometry/Tank.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// The particles of one written time as a picture.
struct SnapshotPicture
{
    std::string png;
    std::string caption;
};

/// Liquid coloured by pressure between grey walls, in the inertial frame, seen along the empty direction; in 3D a slice
/// two spacings thick through the middle of the tank along its longer side. All have one scale of colours, up to the
/// pressure that one particle in a hundred exceeds.
std::vector<SnapshotPicture>
snapshotPictures(const Case& theCase, const Tank& tank, const std::vector<TimeDirectory>& times);

/// `count` of them, spread evenly, the last among them.
std::vector<TimeDirectory> spread(const std::vector<TimeDirectory>& times, std::size_t count);

} // namespace slosh
