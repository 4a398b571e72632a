# The table of the sweep beside linear theory: a row a case, what, figure, reference, error, source; last where the peak is.
# awk -f rows.awk sweep.tsv
BEGIN { FS = OFS = "\t" }

NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }

{
    ratio = $column["frequency [omega/omega1]"]
    depth = "depth [m]" in column ? ", depth " $column["depth [m]"] " m" : ""
    range = $column["range [m]"]
    linear = $column["range reference"]
    print "omega/omega1 = " ratio depth ": highest less lowest level, 0 to 10 s", sprintf("%.4f m", range),
        sprintf("%.4f m", linear), sprintf("%+.1f %%", 100*(range - linear)/linear), "linear potential theory"
    if (!(depth in best) || range > best[depth]) { best[depth] = range; at[depth] = ratio }
    if (!(depth in seen)) { seen[depth]; order[++n] = depth }
}

END { for (k = 1; k <= n; ++k) print "Largest response" order[k] ": omega/omega1", at[order[k]], "1", "-", "linear potential theory" }
