// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"
#include "vtk/writeTankOutline.hpp"
#include "vtk/writeVtu.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace slosh
{

// Comma-separated text for gnuplot and spreadsheets, nine digits, a line of names first. Written whole or not at all;
// throw CaseError.

/// x,y,z and those of the fields that the particles of a range have; U becomes U_x,U_y,U_z.
void writeCsv(
    const std::filesystem::path& file, const Particles& particles, ParticleRange range,
    const std::vector<std::string>& fields
);

/// x,y,z: the two ends of each edge, an empty line between two edges (gnuplot's way to lift the pen).
void writeCsv(const std::filesystem::path& file, const TankOutline& outline);

} // namespace slosh
