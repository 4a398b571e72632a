# SPDX-License-Identifier: GPL-3.0-or-later
# Where the work of the tank has gone at the end of the run, in per cent of the positive work, fields between tabs: positive work, [J],
# what the tank has taken out again, what the liquid has gained, what has been taken by viscosity, density diffusion, walls,
# re-initialisation of the density and stops, and the residual. Nothing where the tank has done no work, or was moved by the liquid.
BEGIN {
    n = readRows("energies/0/energies.dat", row)
    put = row[n, 7]
    if (put == 0 || put - row[n, 6] > 2*put || put < 1e-3*row[1, 4]) exit
    gained = row[n, 3] + row[n, 4] + row[n, 5] - row[1, 3] - row[1, 4] - row[1, 5]
    printf "%.3g\t%.3g\t%.3g", put, 100*(put - row[n, 6])/put, 100*gained/put
    for (c = 8; c <= 13; ++c) printf "\t%.2g", 100*row[n, c]/put
    print ""
}
