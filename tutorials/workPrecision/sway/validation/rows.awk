# Rows of the table of results from workPrecision.csv. awk -F, -f rows.awk workPrecision.csv
NR == 1 {
    for (k = 1; k <= NF; ++k) column[$k] = k
    next
}

$column["status"] == "finished" {
    error = sprintf("%.3g %%", 100 * $column["error"])
    order = $column["observedOrder"]
    printf "%s, dx = %.3g m: difference of the gauge, 0 to 8 s\t%s\t0\t%s\tnonlinear potential flow; %.3g s of CPU, %d particles%s\n", \
        $column["scheme"], $column["particleSpacing"], error, error, $column["cpuSeconds"], $column["particles"], \
        order == "nan" ? "" : sprintf(", order %.2g", order)
}
