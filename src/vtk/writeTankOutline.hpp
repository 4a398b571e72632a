// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"

#include <filesystem>

namespace slosh
{

/// The edges of the tank where it stands at one instant: the section of a 2D scene (in the middle of its empty
/// direction, where the particles are), or the edges in 3D.
struct TankOutline : Outline
{
    TankOutline(const Tank& tank, const SolverFrame& frame);
};

/// Writes it as VTK lines (.vtp), with the options of writeVtu(). Throws CaseError.
void writeTankOutline(const std::filesystem::path& file, const TankOutline& outline, double time);

} // namespace slosh
