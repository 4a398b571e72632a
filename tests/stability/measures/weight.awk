# SPDX-License-Identifier: GPL-3.0-or-later
# Mean of the liquid's force on the tank from the time `from` on over its weight, less 1.
BEGIN {
    n = readRows("forces/0/force.dat", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from) { sum -= row[i, 4]; ++count }
    printf "%.3g", sum/count/(9.81*logged("blockParticles", "Mass            : ")) - 1
}
