// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particleFiles.hpp"
#include "scene/Scene.hpp"
#include "vtk/writeSurface.hpp"

namespace slosh
{

/// The liquid's free surface and what the liquid has there, in the frame of the particles.
struct LiquidSurface
{
    Surface surface;
    SurfaceFields fields;
};

/// F = 1/2 (sampling/samplePoint.hpp) on a lattice of at most one spacing, where it is not behind a wall or in a body;
/// U and p of liquidMean(). Throws CaseError.
LiquidSurface liquidSurface(const Scene& scene, const Particles& particles, const TimeState& state);

} // namespace slosh
