# SPDX-License-Identifier: GPL-3.0-or-later
# The tables of docs/errorAgainstRunTime.md, one for each comparison. awk -F, -f table.awk summary.txt workPrecision.csv
# The summary names the comparisons and their references in the order of the table.
FILENAME ~ /\.txt$/ {
    if (split($0, part, ": error against ") == 2) title[++titles] = $0
    next
}

FNR == 1 {
    for (k = 1; k <= NF; ++k) column[$k] = k
    next
}

$column["comparison"] != comparison {
    comparison = $column["comparison"]
    printf "\n%s:\n\n", title[++number]
    print "| scheme | spacing | error | CPU | steps | evaluations | particles or cells | order to the coarser |"
    print "|---|---|---|---|---|---|---|---|"
}

{
    scheme = $column["scheme"]
    sub(/^scheme=/, "", scheme)
    error = $column["status"] == "finished" ? ($column["error"] == "nan" ? "-" : sprintf("%.3g %%", 100*$column["error"])) : $column["status"]
    order = $column["observedOrder"]
    printf "| %s | %.3g m | %s | %.3g s | %d | %s | %d | %s |\n", scheme, $column["particleSpacing"], error, $column["cpuSeconds"], \
        $column["steps"], ($column["evaluations"] > 0 ? $column["evaluations"] : "-"), $column["particles"], \
        order == "nan" ? "-" : sprintf("%.2g", order)
}
