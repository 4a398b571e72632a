# SPDX-License-Identifier: GPL-3.0-or-later
# The table of the sweep beside linear theory: what, figure, reference, error, source. Of one depth a row a case, of several those at
# 0.8, 1 and 1.2 omega1; the largest error of all; where the peak of each depth is.
# awk -f rows.awk sweep.tsv
BEGIN { FS = OFS = "\t"; source = "linear potential theory" }

NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }

{
    ratio = $column["frequency [omega/omega1]"]
    several = "depth [m]" in column
    depth = several ? ", depth " $column["depth [m]"] " m" : ""
    range = $column["range [m]"]
    linear = $column["range reference"]
    error = 100*(range - linear)/linear
    if (error^2 > worst^2) { worst = error; where = "omega/omega1 = " ratio depth }
    if (!several || ratio == 0.8 || ratio == 1 || ratio == 1.2)
        print "omega/omega1 = " ratio depth ": highest less lowest level, 0 to 10 s", sprintf("%.4f m", range),
            sprintf("%.4f m", linear), sprintf("%+.1f %%", error), source
    if (!(depth in best)) order[++n] = depth
    if (range > best[depth]) { best[depth] = range; at[depth] = ratio }
}

END {
    print "Largest error of " NR - 1 " cases", where, "-", sprintf("%+.1f %%", worst), source
    for (k = 1; k <= n; ++k) print "Largest response" order[k] ": omega/omega1", at[order[k]], "1", "-", source
}
