// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

class vtkDataObject;
class vtkXMLWriter;

namespace slosh
{

/// How every VTK file of ours is written: `object` with the field array TimeValue, appended raw, zlib-compressed,
/// 64-bit block headers; whole or not at all. Throws CaseError.
void writeXml(const std::filesystem::path& file, vtkXMLWriter& writer, vtkDataObject& object, double time);

} // namespace slosh
