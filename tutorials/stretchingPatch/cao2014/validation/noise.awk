# SPDX-License-Identifier: GPL-3.0-or-later
# Pressure of the particles against the exact one at an instant, and the energy that is left at the end, of one case:
#   awk -v case=<name> -v instant=<t> -f noise.awk a.dat b.dat p.dat energies.dat fluid.csv
# prints: name, sqrt(mean (p - p_exact)^2)/p_c, (kinetic + internal at the end)/(the same at the start) - 1.
/^#/ { next }

FILENAME ~ /\/[abp]\.dat$/ {
    if ($1 > instant - 1e-9 && !(FILENAME in exact)) {
        exact[FILENAME] = $3
        if (FILENAME ~ /a\.dat$/) a = $3
        if (FILENAME ~ /b\.dat$/) b = $3
        if (FILENAME ~ /p\.dat$/) pc = $3
    }
    next
}

FILENAME ~ /energies/ {
    energy = $2 + $5
    if (!start) start = energy
    next
}

{
    split($0, value, ",")
    if (value[1] == "x") next
    off = value[4] - pc*(1 - (value[1]/a)^2 - (value[3]/b)^2)
    squares += off*off
    ++n
}

END { print case, sqrt(squares/n)/pc, energy/start - 1 }
