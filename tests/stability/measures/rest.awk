# SPDX-License-Identifier: GPL-3.0-or-later
# Largest kinetic energy relative to the tank from the time `from` on (and up to `until`), over m g D.
BEGIN {
    n = readRows("energies/0/energies.dat", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from && (!until || row[i, 1] <= until)) most = max(most, row[i, 2])
    printf "%.3g", most/(logged("blockParticles", "Mass            : ")*9.81*depth)
}
