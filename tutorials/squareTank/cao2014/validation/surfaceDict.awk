# SPDX-License-Identifier: GPL-3.0-or-later
# A dictionary of one function: the surface's height over a lattice of points, for probeSample -dict. awk -f surfaceDict.awk
BEGIN {
    n = 24
    print "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n    location    \"system\";"
    print "    object      surfaceDict;\n}\n"
    print "surface\n{\n    type            interfaceHeight;\n    locations\n    ("
    for (i = 0; i < n; ++i)
        for (j = 0; j < n; ++j) printf "        (%.5f %.5f 0)\n", -0.285 + 0.57*i/(n - 1), -0.285 + 0.57*j/(n - 1)
    print "    );\n}"
}
