# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows what particlesToVTK has written of a case, as one wants to see it first: the liquid coloured by pressure, the tank's
outline, the free surface where there is one (particlesToVTK -surface), time and scale. In the case's directory, in a window

    paraview --script=$SLOSH_ETC/paraview/showCase.py

or into files; without a display behind  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" :

    pvpython --no-mpi $SLOSH_ETC/paraview/showCase.py [--case <dir>] [--time <s>] [--png <file>] [--animation <file>]
                                                 [--size <w>x<h>] [--range <Pa>:<Pa>]

--png: a picture of the time nearest to --time, default the last. --animation: all times, ten a second, as .avi, .ogv or, for a
sequence of numbered pictures, .png. In the default frame of particlesToVTK the tank moves. --range: of the colours; default:
from 0 to the pressure that one particle in a hundred exceeds. ParaView 5.11.
"""

import argparse
import json
import os
import re
import sys

from paraview import servermanager, simple
from paraview.simple import (
    AnnotateTimeFilter, ColorBy, GetActiveViewOrCreate, GetAnimationScene, GetColorTransferFunction, GetScalarBar, OpenDataFile,
    RenameSource, Render, SaveAnimation, SaveScreenshot, Show)

BLUE_TO_RED = [(0, 0x08306B), (0.2, 0x2171B5), (0.4, 0x6BAED6), (0.6, 0xFDD49E), (0.8, 0xEF6548), (1, 0x990000)]


def pairOf(kind, separator):
    def pair(text):
        first, second = text.split(separator)
        return [kind(first), kind(second)]

    return pair


def readOptions():
    options = argparse.ArgumentParser(prog="showCase.py", description=__doc__, usage=argparse.SUPPRESS, allow_abbrev=False,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("case", "png", "animation"):
        options.add_argument("--" + name)
    options.add_argument("--time", type=float)
    options.add_argument("--size", type=pairOf(int, "x"), default=[1000, 640])
    options.add_argument("--range", type=pairOf(float, ":"))
    chosen = options.parse_args(sys.argv[1:])
    chosen.case = chosen.case or os.environ.get("SLOSH_CASE", ".")
    if not os.path.exists(path(chosen.case, "fluid.vtu")):
        sys.exit(f"there is no {path(chosen.case, 'fluid.vtu')}: particlesToVTK makes it")
    return chosen


def path(case, name):
    return os.path.join(case, "VTK", name + ".series")


def sourceOf(case, name):
    source = OpenDataFile(path(case, name))
    RenameSource({"fluid.vtu": "liquid", "wall.vtu": "walls", "tank.vtp": "tank", "surface.vtp": "free surface"}[name], source)
    return source


def spacingOf(case):
    """The particles' spacing, [m]: it stands in every time directory."""
    for name in os.listdir(case):
        state = os.path.join(case, name, "uniform", "tankState")
        if os.path.exists(state):
            with open(state, encoding="utf-8") as text:
                return float(re.search(r"^spacing\s+([^;\s]+);", text.read(), re.MULTILINE)[1])
    sys.exit(f"there is no time directory in {case}")


def timesOf(case):
    with open(path(case, "fluid.vtu"), encoding="utf-8") as text:
        return [entry["time"] for entry in json.load(text)["files"]]


def boundsOver(source, times):
    """The least and greatest coordinates at any of the times."""
    low, high = [float("inf")] * 3, [float("-inf")] * 3
    for time in times:
        source.UpdatePipeline(time)
        bounds = source.GetDataInformation().GetBounds()
        low = [min(a, b) for a, b in zip(low, bounds[0::2])]
        high = [max(a, b) for a, b in zip(high, bounds[1::2])]
    return low, high


def pressuresOf(fluid, time):
    fluid.UpdatePipeline(time)
    array = servermanager.Fetch(fluid).GetPointData().GetArray("p")
    return sorted(array.GetValue(i) for i in range(array.GetNumberOfTuples()))


def rangeOf(options, fluid, times):
    if options.range:
        return options.range
    highest = max(pressures[int(0.99 * (len(pressures) - 1))] for pressures in (pressuresOf(fluid, time) for time in times) if pressures)
    digits = 10 ** (len(str(int(highest))) - 2) if highest >= 10 else 1
    return 0, max(digits, -(-highest // digits) * digits)


def scaleWidth(view):
    """The share of the view's width that the scale of colours takes at the right."""
    return 130 / view.ViewSize[0]


def setCamera(view, low, high):
    """A 2D tank from the front, vertical up; a 3D one from a corner, somewhat from above."""
    size = [b - a for a, b in zip(low, high)]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    flat = [d for d in range(3) if size[d] < 1e-6 * max(size)]
    direction = {0: (1, 0, 0), 1: (0, -1, 0)}.get(flat[0], (0, 0, 1)) if flat else (0.55, -1, 0.4)
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + 3 * max(size) * d for m, d in zip(middle, direction)]
    view.CameraViewUp = [0, 0, 1]
    if flat:
        view.CameraParallelProjection = 1
        right = 1 if flat[0] == 0 else 0
        width, height = view.ViewSize
        free = 1 - scaleWidth(view)
        view.CameraParallelScale = max(0.62 * size[2], 0.54 * size[right] * height / (width * free))
        view.CameraFocalPoint[right] += view.CameraParallelScale * width / height * scaleWidth(view)
        view.CameraPosition = [f + 3 * max(size) * d for f, d in zip(view.CameraFocalPoint, direction)]
    else:
        view.ResetCamera(low[0], high[0], low[1], high[1], low[2], high[2])
        view.GetActiveCamera().Dolly(1.2)
    return bool(flat)


def colourByPressure(display, view, ends):
    ColorBy(display, ("POINTS", "p"))
    colours = GetColorTransferFunction("p")
    colours.ColorSpace = "RGB"
    points = []
    for share, rgb in BLUE_TO_RED:
        points += [ends[0] + share * (ends[1] - ends[0]), (rgb >> 16) / 255, (rgb >> 8 & 255) / 255, (rgb & 255) / 255]
    colours.RGBPoints = points
    colours.AutomaticRescaleRangeMode = "Never"
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "pressure [Pa]", ""
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [1 - scaleWidth(view), 0.15], 0.65
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = 14
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.0f", "%.0f"


def colourAll(display, rgb):
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = rgb


def main():
    options = readOptions()
    simple._DisableFirstRenderCameraReset()
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = options.size
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0

    times = timesOf(options.case)
    time = min(times, key=lambda t: abs(t - options.time)) if options.time is not None else times[-1]
    fluid, tank = sourceOf(options.case, "fluid.vtu"), sourceOf(options.case, "tank.vtp")
    isFlat = setCamera(view, *boundsOver(tank, times))
    GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    view.ViewTime = GetAnimationScene().AnimationTime = time
    spacing = spacingOf(options.case)

    def showPoints(source, name):
        display = Show(source, view)
        display.Representation = "Point Gaussian"
        display.GaussianRadius = 0.65 * spacing
        display.ShaderPreset = name
        return display

    shape = "Plain circle" if isFlat else "Sphere"
    colourByPressure(showPoints(fluid, shape), view, rangeOf(options, fluid, times if options.animation else [time]))
    if isFlat and os.path.exists(path(options.case, "wall.vtu")):
        wall = showPoints(sourceOf(options.case, "wall.vtu"), shape)
        colourAll(wall, [0.73, 0.76, 0.79])
    outline = Show(tank, view)
    colourAll(outline, [0, 0, 0])
    outline.LineWidth = 2
    if os.path.exists(path(options.case, "surface.vtp")):
        surface = Show(sourceOf(options.case, "surface.vtp"), view)
        colourAll(surface, [0, 0, 0] if isFlat else [0.55, 0.75, 0.95])
        surface.LineWidth = 2
        surface.Opacity = 1 if isFlat else 0.35
    instant = AnnotateTimeFilter(fluid, Format="t = {time:.2f} s")
    RenameSource("time", instant)
    clock = Show(instant, view)
    clock.Color = [0, 0, 0]
    clock.FontSize = 20
    clock.WindowLocation = "Upper Left Corner"

    Render(view)
    if options.png:
        SaveScreenshot(options.png, view, ImageResolution=view.ViewSize)
    if options.animation:
        SaveAnimation(options.animation, view, ImageResolution=view.ViewSize, FrameRate=10)


main()
