// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace slosh
{

/// The fields a file holds where none are named: U [m/s], p [Pa], rho [kg/m^3], origId.
const std::vector<std::string>& usualFields();

/// The fields of a range of particles that files can hold beside the points: usualFields() and those of
/// Particles::more.
std::vector<std::string> fieldNames(const Particles& particles, ParticleRange range);
/// Of the liquid, then those that walls alone have.
std::vector<std::string> fieldNames(const Particles& particles);

/// Writes the particles of a range as a VTK unstructured grid (.vtu): one vertex cell a particle, those of the point
/// arrays `fields` that it has in double precision, field array TimeValue [s]. XML, binary appended, zlib-compressed:
/// what ParaView and VTK's vtkXMLUnstructuredGridReader open. Positions and velocities go in as they are; changeFrame()
/// first where another frame is wanted. The file is written whole or not at all. Throws CaseError: a field that no
/// particle has, or the system's reason for a failed write.
void writeVtu(
    const std::filesystem::path& file, const Particles& particles, ParticleRange range,
    const std::vector<std::string>& fields, double time
);

} // namespace slosh
