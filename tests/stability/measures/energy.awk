# SPDX-License-Identifier: GPL-3.0-or-later
# What the liquid has gained beyond the work done on it, largest at any time: (E - E(0) - W)/scale, E its kinetic, potential and
# internal energy in the inertial frame, W the work of the tank (function energies { budget yes; }), scale = max(largest |W|, m g depth).
BEGIN {
    n = readRows("energies/0/energies.dat", row)
    most = logged("blockParticles", "Mass            : ")*9.81*depth
    worst = 0
    for (i = 2; i <= n; ++i)
    {
        work = row[i, 6]
        most = max(most, abs(work))
        worst = max(worst, row[i, 3] + row[i, 4] + row[i, 5] - row[1, 3] - row[1, 4] - row[1, 5] - work)
    }
    printf "%.3g", worst/most
}
