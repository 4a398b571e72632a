# SPDX-License-Identifier: GPL-3.0-or-later
# The mean error of each figure over runs that differ in the spacing alone, with the standard error of the mean: rows for the table.
#     awk -f meanOfSpacings.awk <comparisons.tsv of each run>
BEGIN { FS = OFS = "\t" }

/^#/ || $4 !~ /^-?[0-9]/ { next }

{
    figure = $1
    sub(/^D\/dx = [0-9]+, /, "", figure)
    if (!(figure in n)) order[++figures] = figure
    split($4, error, " ")
    unit[figure] = error[2]
    source[figure] = $5
    ++n[figure]
    sum[figure] += error[1]
    squares[figure] += error[1]^2
}

END {
    for (k = 1; k <= figures; ++k) {
        f = order[k]
        if (n[f] < 2) continue
        mean = sum[f]/n[f]
        spread = sqrt((squares[f] - n[f]*mean^2)/(n[f] - 1)/n[f])
        print "mean error of " n[f] " spacings, " f, "-", "-", sprintf("%.3g +- %.2g %s", mean, spread, unit[f]), source[f]
    }
}
