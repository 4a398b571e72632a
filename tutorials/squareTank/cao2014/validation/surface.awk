# SPDX-License-Identifier: GPL-3.0-or-later
# The elevation of the surface over its lattice of points at one time, x y eta [m], a blank line after each row of them:
#   awk -v time=4 -f surface.awk postProcessing/probeSample/surface/3.5/height.dat
BEGIN { still = 0.29972; n = 24; points = 0 }
/^# Location :/ { gsub(/[()]/, ""); x[points] = $4; y[points++] = $5; next }
/^#/ { next }
{
    distance = $1 > time ? $1 - time : time - $1
    if (line == "" || distance < nearest) { nearest = distance; line = $0 }
}
END {
    split(line, value, " ")
    for (k = 0; k < points; ++k) {
        if (k > 0 && k % n == 0) print ""
        print x[k], y[k], value[2 + 2*k] - still
    }
}
