# SPDX-License-Identifier: GPL-3.0-or-later
# Table of tabulated6DoFMotion, rows of 1 ms, out of a record of the roll, lines "time [s], angle [deg], rate [deg/s],
# acceleration [deg/s^2]" of 10 ms. The record is a cubic spline of 40 equal pieces, so a row follows exactly from the nearest
# line in the same piece. Between rows the motion's acceleration leaves the spline's by up to their distance times the third
# derivative, at the one end with this sign, at the other with that: at most 1.1 of 124 deg/s^2 with rows of 1 ms, 9 with
# the lines of 10 ms themselves. A row before t = 0 gives the motion its acceleration from the start; without it the first
# interval would begin with the negative of that.
BEGIN {
    n = 0
    FS = ","
    pieces = 40
    step = 0.001
}

/^[0-9]/ {
    t[n] = $1
    theta[n] = $2
    rate[n] = $3
    acceleration[n++] = $4
}

# The angle on the spline; before the first line its first piece goes on.
function angle(time,    interval, width, piece, first, last, i, s, third)
{
    interval = t[1] - t[0]
    width = t[n - 1]/pieces
    piece = time < 0 ? 0 : int(time/width)
    if (piece > pieces - 1) piece = pieces - 1
    first = int(piece*width/interval + 1 - 1e-6)
    last = int((piece + 1)*width/interval + 1e-6)
    i = int(time/interval + 0.5)
    if (i < first) i = first
    if (i > last) i = last
    third = (acceleration[last] - acceleration[first])/(t[last] - t[first])
    s = time - t[i]
    return theta[i] + s*(rate[i] + s/2*(acceleration[i] + s/3*third))
}

END {
    rows = int(t[n - 1]/step + 0.5)
    print rows + 2 "\n("
    for (k = -1; k <= rows; ++k) printf "(%.3f ((0 0 0) (%.9f 0 0)))\n", k*step, angle(k*step)
    print ")"
}
