# SPDX-License-Identifier: GPL-3.0-or-later
# Mean of the pressure at the middle of the bottom from the time `from` on, less `exact`, over rho0 c0^2: a relative density.
BEGIN {
    n = readRows("pressure/0/p", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from) { sum += row[i, 2]; ++count }
    printf "%.3g", (sum/count - exact)/(1000*logged("blockParticles", "Speed of sound  : ")^2)
}
