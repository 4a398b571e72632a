# SPDX-License-Identifier: GPL-3.0-or-later
# Mean velocity of the centre of mass in the inertial frame between the times `from` and `until` along `axis` (1 2 3: x y z) over
# `exact`, less 1.
BEGIN {
    n = readRows("centreOfMass/0/centreOfMass.dat", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from && row[i, 1] <= until) { sum += row[i, 7 + axis]; ++count }
    printf "%.3g", sum/count/exact - 1
}
