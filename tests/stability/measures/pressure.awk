# SPDX-License-Identifier: GPL-3.0-or-later
# Mean of the pressure at the scene's probe, in the middle of the bottom unless it says otherwise, from the time `from` on over `exact`, less 1.
BEGIN {
    n = readRows("pressure/0/p", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from) { sum += row[i, 2]; ++count }
    printf "%.3g", sum/count/exact - 1
}
