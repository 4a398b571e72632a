# SPDX-License-Identifier: GPL-3.0-or-later
# The first four peaks of peakStatistics against the means and standard deviations of 102 runs, as rows of results.tsv.
BEGIN {
    split("4300 5721 17239 12231", mean, " ")
    split("799 1032 6881 4964", deviation, " ")
    OFS = "\t"
}

/^#/ { next }

{
    if (++n > 4) exit
    print "impact " n ", at " sprintf("%.2f", $1) " s: peak of the average over 1 ms", sprintf("%.0f Pa", $2), \
        mean[n] " +- " deviation[n] " Pa", sprintf("%.0f %%", 100*($2/mean[n] - 1)), \
        "SPHERIC 10, mean and standard deviation of 102 runs"
}

END {
    if (n < 4) print "impacts 1 to 4 on the roof", n + 0, 4, n - 4, "SPHERIC 10"
}
