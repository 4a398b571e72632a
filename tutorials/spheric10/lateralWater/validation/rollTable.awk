# SPDX-License-Identifier: GPL-3.0-or-later
# Table of tabulated6DoFMotion out of a record of roll angles, lines "time [s], angle [deg]".
BEGIN { FS = "," }

/^[0-9]/ { row[n++] = sprintf("(%s ((0 0 0) (%s 0 0)))", $1, $2) }

END {
    print n "\n("
    for (i = 0; i < n; ++i) print row[i]
    print ")"
}
