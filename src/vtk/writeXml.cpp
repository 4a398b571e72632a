// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk/writeXml.hpp"

#include "base/CaseError.hpp"
#include "base/writeFile.hpp"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkXMLWriter.h>

namespace slosh
{

void writeXml(const std::filesystem::path& file, vtkXMLWriter& writer, vtkDataObject& object, double time)
{
    vtkNew<vtkDoubleArray> timeValue;
    timeValue->SetName("TimeValue");
    timeValue->InsertNextValue(time);
    object.GetFieldData()->AddArray(timeValue);

    writer.SetInputData(&object);
    writer.SetDataModeToAppended();
    writer.EncodeAppendedDataOff();
    writer.SetCompressorTypeToZLib();
    writer.SetHeaderTypeToUInt64();
    writer.WriteToOutputStringOn();
    if (writer.Write() != 1)
    {
        throw CaseError("VTK cannot write " + file.string());
    }
    writeFile(file, writer.GetOutputString());
}

} // namespace slosh
