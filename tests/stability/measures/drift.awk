# SPDX-License-Identifier: GPL-3.0-or-later
# How far the centre of mass is at the end from where it was, vertically, over the particle spacing.
BEGIN {
    n = readRows("centreOfMass/0/centreOfMass.dat", row)
    printf "%.3g", (row[n, 4] - row[1, 4])/logged("blockParticles", "Spacing         : ")
}
