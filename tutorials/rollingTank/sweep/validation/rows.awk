# SPDX-License-Identifier: GPL-3.0-or-later
# What Cao et al. say of the nine cases, beside what the table of mean peaks holds: one row a case and one a statement.
# awk -f rows.awk peakMap.txt
BEGIN { OFS = "\t"; split("4 8 12", angles, " "); source = "Cao et al. 2014, Fig. 13" }

/^#/ { next }

{
    if (!(($1, $2) in coarser)) pairs[++p] = $1 SUBSEP $2
    else {
        r = coarser[$1, $2]
        change[$1, $2] = change[$1, $2] sprintf("%s deg, %s rad/s: mean peak at D/dx = %s less that at %s\t%+.0f +- %.0f Pa\t0\t%+.1f %%\tconvergence\n",
            $1, $2, $3, r, $4 - mean[$1, $2, r], sqrt($5^2 + error[$1, $2, r]^2), 100*($4 - mean[$1, $2, r])/mean[$1, $2, r])
    }
    coarser[$1, $2] = $3
    mean[$1, $2, $3] = $4
    error[$1, $2, $3] = $5
    if (!($3 in seen)) { seen[$3]; order[++n] = $3 }
    reference = $2 == 4 ? "-" : $8 " Pa"
    off = $2 == 4 ? "-" : sprintf("%.0f %%", 100*($4 - $8)/$8)
    print $1 " deg, " $2 " rad/s, D/dx = " $3 ": mean peak, 10-20 s, both walls", $4 " +- " $5 " Pa", reference, off,
        ($2 == 4 ? "" : "linear theory")
}

END {
    for (k = 1; k <= p; ++k) printf "%s", change[pairs[k]]
    for (k = 1; k <= n; ++k) {
        r = order[k]
        for (i = 1; i <= 3; ++i) {
            a = angles[i]
            other = mean[a, 2, r] > mean[a, 6, r] ? mean[a, 2, r] : mean[a, 6, r]
            if (other > 0 && mean[a, 4, r] > 0)
            {
                ratio = mean[a, 4, r]/other
                print a " deg, D/dx = " r ": highest at 4 rad/s, over the next highest", sprintf("%.2f", ratio),
                    "above 1, up to about 2", (ratio < 1 ? "not the highest" : ratio > 2.05 ? sprintf("%.2f above", ratio - 2) : "inside"),
                    source
            }
        }
        if (!((12, 6, r) in mean && (12, 4, r) in mean && (12, 2, r) in mean)) continue
        grows = 1
        for (w = 2; w <= 6; w += 2)
            for (i = 2; i <= 3; ++i) grows = grows && mean[angles[i], w, r] > mean[angles[i - 1], w, r]
        print "D/dx = " r ": pressure grows with the angle at all three frequencies", (grows ? "yes" : "no"), "yes", "-", source
    }
}
