# SPDX-License-Identifier: GPL-3.0-or-later
# Standard deviation of the pressure at the middle of the bottom from the time `from` on, over `scale`.
BEGIN {
    n = readRows("pressure/0/p", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from) { sum += row[i, 2]; square += row[i, 2]^2; ++count }
    printf "%.3g", sqrt(max(0, square/count - (sum/count)^2))/scale
}
