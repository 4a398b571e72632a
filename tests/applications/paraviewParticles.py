# SPDX-License-Identifier: GPL-3.0-or-later
"""paraviewParticles.py <case>.foam ...: what ParaView's OpenFOAM reader finds: for each case and time a line
`case <name> time <time> fluid <N>`, then x y z, U, p, rho and origId of each particle."""

import sys

from paraview.simple import OpenFOAMReader, servermanager

for name in sys.argv[1:]:
    reader = OpenFOAMReader(FileName=name)
    reader.SkipZeroTime = 0
    reader.SMProxy.InvokeCommand("Refresh")  # the button of that name: without it the times stay as they were
    reader.UpdatePipelineInformation()
    reader.MeshRegions = ["lagrangian/fluid"]
    for time in reader.TimestepValues:
        reader.UpdatePipeline(time)
        blocks = servermanager.Fetch(reader).NewIterator()
        cloud = blocks.GetCurrentDataObject()
        points = cloud.GetPointData()
        fields = [points.GetArray(field) for field in ("U", "p", "rho", "origId")]
        print("case", name, "time", repr(time), "fluid", cloud.GetNumberOfPoints())
        for i in range(cloud.GetNumberOfPoints()):
            values = list(cloud.GetPoint(i))
            for field in fields:
                values += field.GetTuple(i)
            print(*map(repr, values))
        blocks.GoToNextItem()
        if not blocks.IsDoneWithTraversal():
            sys.exit("there is more than the one cloud asked for")
