# SPDX-License-Identifier: GPL-3.0-or-later
# What the energy budget leaves open, largest at any time: |E - E(0) - W + all that was taken|/scale (function energies { budget
# yes; }). scale: the work that the tank has put in or that it has taken out, in the whole run, whichever is larger; m g depth
# where it has not moved.
BEGIN {
    n = readRows("energies/0/energies.dat", row)
    scale = max(row[n, 7], row[n, 7] - row[n, 6])
    if (scale == 0) scale = logged("blockParticles", "Mass            : ")*9.81*depth
    for (i = 1; i <= n; ++i) worst = max(worst, abs(row[i, 13]))
    printf "%.3g", worst/scale
}
