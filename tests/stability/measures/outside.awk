# SPDX-License-Identifier: GPL-3.0-or-later
# Most particles outside the tank at any sample.
BEGIN {
    n = readRows("particlesOutside/0/particlesOutside.dat", row)
    for (i = 1; i <= n; ++i) most = max(most, row[i, 2])
    printf "%d", most
}
