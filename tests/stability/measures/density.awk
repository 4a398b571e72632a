# SPDX-License-Identifier: GPL-3.0-or-later
# Largest |rho/rho0 - 1| at any sample (up to the time `until`).
BEGIN {
    n = readRows("densityDeviation/0/densityDeviation.dat", row)
    for (i = 1; i <= n; ++i) if (!until || row[i, 1] <= until) most = max(most, row[i, 2])
    printf "%.3g", most
}
