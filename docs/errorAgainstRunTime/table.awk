# SPDX-License-Identifier: GPL-3.0-or-later
# The tables of an errorAgainstRunTime.md, made of a study's summary.txt and workPrecision.csv; the summary names the comparisons and
# their references in the order of the table.
#     awk -F, -v study=<words> -f table.awk summary.txt workPrecision.csv     a line for each comparison: what each scheme reaches
#     awk -F, -v full=1 -f table.awk summary.txt workPrecision.csv            a table for each comparison: all runs
FILENAME ~ /\.txt$/ {
    if (split($0, part, ": error against ") == 2) title[++titles] = $0
    next
}

FNR == 1 {
    for (k = 1; k <= NF; ++k) column[$k] = k
    next
}

$column["comparison"] != comparison {
    if (comparison != "" && !full) line()
    comparison = $column["comparison"]
    ++number
    split("", best)
    split("", cheapest)
    if (full)
    {
        printf "\n%s:\n\n", title[number]
        print "| scheme | spacing | error | CPU | steps | evaluations | particles or cells | order to the coarser |"
        print "|---|---|---|---|---|---|---|---|"
    }
}

{
    scheme = $column["scheme"]
    sub(/^scheme=/, "", scheme)
    finished = $column["status"] == "finished" && $column["error"] != "nan"
}

full {
    error = finished ? percent($column["error"]) : $column["status"] == "finished" ? "-" : $column["status"]
    order = $column["observedOrder"]
    printf "| %s | %.3g m | %s | %.3g s | %d | %s | %d | %s |\n", scheme, $column["particleSpacing"], error, $column["cpuSeconds"], \
        $column["steps"], ($column["evaluations"] > 0 ? $column["evaluations"] : "-"), $column["particles"], \
        order == "nan" ? "-" : sprintf("%.2g", order)
}

!full && finished {
    error = $column["error"] + 0
    cpu = $column["cpuSeconds"] + 0
    if (!(scheme in best) || error < least[scheme])
    {
        least[scheme] = error
        best[scheme] = sprintf("%s, %.3g mm, %s", percent(error), 1000*$column["particleSpacing"], seconds(cpu))
    }
    for (target = 10; scheme != "interFoam" && target >= 2; target = target > 5 ? 5 : target - 3)
        if (100*error <= target && (!(target in cheapest) || cpu < cost[target]))
        {
            cost[target] = cpu
            cheapest[target] = seconds(cpu) " " abbreviation(scheme)
        }
}

END { if (!full) line() }

# percent <share>: with 3 digits; what is below 1e-6 is rounding.
function percent(share)
{
    return share < 1e-9 ? "0" : sprintf("%.3g %%", 100*share)
}

function seconds(cpu)
{
    return sprintf(cpu < 100 ? "%.2g s" : "%.0f s", cpu)
}

function abbreviation(scheme)
{
    return scheme == "paper" ? "P" : scheme == "recommended" ? "R" : scheme == "smallWaves" ? "W" : "O"
}

function cell(scheme)
{
    return scheme in best ? best[scheme] : "-"
}

function line(    other, what)
{
    other = "friction" in best ? "friction" : "wide"
    what = title[number]
    sub(/: error against .*/, "", what)
    what = titles > 1 ? study ": " what : study
    printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", what, cell("paper"), cell("recommended"), cell("smallWaves"), cell(other), \
        cell("interFoam"), reached(10), reached(5), reached(2)
}

function reached(target)
{
    return target in cheapest ? cheapest[target] : "-"
}
