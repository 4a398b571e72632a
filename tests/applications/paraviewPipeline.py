# SPDX-License-Identifier: GPL-3.0-or-later
"""paraviewPipeline.py <showCase.py> <its options>: runs it, then says what stands in its view, a line each:
`points <of the fluid>`, `array <coloured by>`, `colours <from> <to>`, `title <of the scale>`, `camera <focus> <position> <up>`,
`shows <sources>`; of each picture named by --png `picture <width> <height>` and the shares of its pixels that are white, grey
or coloured."""

import runpy
import sys

script = sys.argv[1]
sys.argv = sys.argv[1:]
runpy.run_path(script, run_name="__main__")

from paraview import simple  # noqa: E402
from paraview.modules.vtkRemotingViews import vtkSMTransferFunctionManager  # noqa: E402, F401
from vtkmodules.vtkIOImage import vtkPNGReader  # noqa: E402

view = simple.GetActiveView()
sources = simple.GetSources()
fluid = next(source for (name, _), source in sources.items() if name == "liquid")
display = simple.GetRepresentation(fluid, view)
colours = simple.GetColorTransferFunction("p")
print("points", fluid.GetDataInformation().GetNumberOfPoints())
print("array", *display.ColorArrayName)
print("colours", colours.RGBPoints[0], colours.RGBPoints[-4])
print("title", simple.GetScalarBar(colours, view).Title)
print("camera", *view.CameraFocalPoint, *view.CameraPosition, *view.CameraViewUp)
print("shows", *sorted(name.replace(" ", "_") for (name, _), source in sources.items() if simple.GetRepresentation(source, view).Visibility))
for option, file in zip(sys.argv, sys.argv[1:]):
    if option == "--png":
        reader = vtkPNGReader()
        reader.SetFileName(file)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        pixels = reader.GetOutput().GetPointData().GetScalars()
        kinds = {"white": 0, "grey": 0, "coloured": 0}
        for i in range(width * height):
            rgb = pixels.GetTuple(i)[:3]
            spread = max(rgb) - min(rgb)
            kinds["coloured" if spread > 40 else "white" if min(rgb) > 250 else "grey"] += 1 / (width * height)
        print("picture", width, height, *(f"{kind} {share:.4f}" for kind, share in kinds.items()))
