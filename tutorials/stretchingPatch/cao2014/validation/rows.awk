# SPDX-License-Identifier: GPL-3.0-or-later
# One row a kernel, rate of stretching and figure: at the finest spacing, with the order observed from the two finest.
#   awk -f rows.awk runs/*/postProcessing/compareSamples/comparisons.tsv noise.txt
BEGIN { OFS = "\t" }

FILENAME ~ /comparisons.tsv$/ {
    if (/^#/) next
    split(FILENAME, part, "/")
    name = part[2]
    split($0, column, "\t")
    quantity = column[1]
    if (!(quantity in known)) { known[quantity]; quantities[++nq] = quantity }
    figure[name, quantity] = column[2]
    reference[name, quantity] = column[3]
    error[name, quantity] = column[4]
    split(name, piece, "_")
    set = piece[1] "_" piece[2]
    if (!(set in sets)) { sets[set]; order[++n] = set }
    if (piece[3] + 0 > finest[set] + 0) { if (finest[set] + 0 != 0) coarser[set] = finest[set]; finest[set] = piece[3] }
    else if (piece[3] + 0 < finest[set] + 0 && piece[3] + 0 > coarser[set] + 0) coarser[set] = piece[3]
    next
}

{
    noise[$1] = $2
    lost[$1] = $3
}

function size(x) { sub(/ %/, "", x); x += 0; return x < 0 ? -x : x }

END {
    for (k = 1; k <= n; ++k) {
        set = order[k]
        split(set, piece, "_")
        label = piece[1] ", A0 = " substr(piece[2], 2) "/s, R/dx = " finest[set] ": "
        fine = set "_" finest[set]
        coarse = set "_" coarser[set]
        for (q = 1; q <= nq; ++q) {
            # The two finest are a factor 2 apart.
            o = size(error[fine, quantities[q]]) > 0 ? \
                log(size(error[coarse, quantities[q]])/size(error[fine, quantities[q]]))/log(finest[set]/coarser[set]) : 0
            print label quantities[q], figure[fine, quantities[q]], reference[fine, quantities[q]], \
                error[fine, quantities[q]] sprintf("; order %.1f", o), "exact solution"
        }
        print label "pressure noise at A0 t = 0.5, rms of p - p exact over p_c", sprintf("%.1f %%", 100*noise[fine]), \
            "0", sprintf("%.1f %% at R/dx = %d", 100*noise[coarse], coarser[set]), "exact solution"
        print label "energy gained (lost) until A0 t = 2", sprintf("%.2f %%", 100*lost[fine]), "0", \
            sprintf("%.2f %% at R/dx = %d", 100*lost[coarse], coarser[set]), "exact: kept"
    }
}
