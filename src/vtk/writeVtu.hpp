// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/Particles.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slosh
{

/// Fields by name that are computed from the particles: a value for each of them.
using DerivedFields = std::map<std::string, std::vector<Vec>>;

/// The fields a VTK file can hold beside the points: U [m/s], p [Pa], rho [kg/m^3], origId.
const std::vector<std::string>& vtuFieldNames();

/// Writes n particles from `first` on as a VTK unstructured grid (.vtu): one vertex cell a particle, point arrays
/// `fields` (of vtuFieldNames() and of `derived`) in double precision, field array TimeValue [s]. XML, binary appended,
/// zlib-compressed: what ParaView and VTK's vtkXMLUnstructuredGridReader open. Positions and velocities go in as they
/// are; changeFrame() first where another frame is wanted. The file is written whole or not at all. Throws CaseError: a
/// field that is none of these, or the system's reason for a failed write.
void writeVtu(const std::filesystem::path& file, const Particles& particles, std::ptrdiff_t first, std::ptrdiff_t n,
              const std::vector<std::string>& fields, double time, const DerivedFields& derived = {});

} // namespace slosh
