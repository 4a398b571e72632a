# SPDX-License-Identifier: GPL-3.0-or-later
# Largest |rho/rho0 - 1| at any sample over what a water hammer of the run's largest speed and the liquid's weight make,
# max |v|/c0 + g depth/c0^2.
BEGIN {
    n = readRows("densityDeviation/0/densityDeviation.dat", row)
    for (i = 1; i <= n; ++i) most = max(most, row[i, 2])
    file = "log.sloshSPHFoam"
    while ((getline line < file) > 0)
    {
        split(line, word, " ")
        if (index(line, "Speed of sound: ") == 1) c0 = word[4]
        if (index(line, "max |v| = ") == 1) speed = max(speed, word[4])
    }
    printf "%.3g", most/(speed/c0 + 9.81*depth/c0^2)
}
