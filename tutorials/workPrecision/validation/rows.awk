# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of the table of results of a study. awk -F, -v study=<beginning of each row> -f rows.awk summary.txt workPrecision.csv
# The summary names the comparisons and their references in the order of the table.
FILENAME ~ /summary.txt$/ {
    if (split($0, part, ": error against ") == 2) {
        description[++described] = part[1]
        source[described] = part[2]
    }
    next
}

FNR == 1 {
    for (k = 1; k <= NF; ++k) column[$k] = k
    next
}

$column["comparison"] != comparison {
    comparison = $column["comparison"]
    ++number
}

$column["status"] == "finished" && $column["error"] != "nan" {
    error = sprintf("%.3g %%", 100 * $column["error"])
    order = $column["observedOrder"]
    scheme = $column["scheme"]
    sub(/^scheme=/, "", scheme)
    printf "%s%s, dx = %.3g m: %s\t%s\t0\t%s\t%s; %.3g s of CPU, %d %s%s\n", \
        study, scheme, $column["particleSpacing"], description[number], error, error, source[number], $column["cpuSeconds"], \
        $column["particles"], scheme == "interFoam" ? "cells" : "particles", order == "nan" ? "" : sprintf(", order %.2g", order)
}
