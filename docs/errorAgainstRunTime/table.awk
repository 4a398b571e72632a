# The table of docs/errorAgainstRunTime.md from workPrecision.csv. awk -F, -f table.awk workPrecision.csv
NR == 1 {
    for (k = 1; k <= NF; ++k) column[$k] = k
    print "| scheme | spacing | error | CPU | steps | evaluations | particles | order to the coarser |"
    print "|---|---|---|---|---|---|---|---|"
    next
}

{
    error = $column["status"] == "finished" ? sprintf("%.3g %%", 100*$column["error"]) : $column["status"]
    order = $column["observedOrder"]
    printf "| %s | %.3g m | %s | %.3g s | %d | %d | %d | %s |\n", $column["scheme"], $column["particleSpacing"], error,
        $column["cpuSeconds"], $column["steps"], $column["evaluations"], $column["particles"], order == "nan" ? "-" : sprintf("%.2g", order)
}
