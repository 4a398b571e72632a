// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vtk/isoSurface.hpp"

#include <filesystem>

namespace slosh
{

/// What is known at each point of a surface.
struct SurfaceFields
{
    std::vector<Vec> U;    ///< [m/s]
    std::vector<double> p; ///< [Pa]
};

/// Writes a surface as VTK polygons and lines (.vtp) with point arrays U, p and, where it has them, Normals, with the
/// options of writeVtu(). Throws CaseError.
void writeSurface(const std::filesystem::path& file, const Surface& surface, const SurfaceFields& fields, double time);

} // namespace slosh
