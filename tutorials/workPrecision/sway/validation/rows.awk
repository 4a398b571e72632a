# Rows of the table of results from workPrecision.csv. awk -F, -f rows.awk workPrecision.csv
NR == 1 {
    for (k = 1; k <= NF; ++k) column[$k] = k
    next
}

$column["status"] == "finished" {
    order = $column["observedOrder"]
    printf "%s, dx = %.3g m: gauge, 0 to 8 s\t%.3g s of CPU, %d particles%s\t0\t%.3g %%\tlinear theory\n", \
        $column["scheme"], $column["particleSpacing"], $column["cpuSeconds"], $column["particles"], \
        order == "nan" ? "" : sprintf(", order %.2g", order), 100 * $column["error"]
}
