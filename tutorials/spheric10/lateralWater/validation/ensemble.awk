# SPDX-License-Identifier: GPL-3.0-or-later
# Rows for the table from sloshSweep's ensemble.tsv: mean and standard deviation of the members, and their mean error with its
# standard error, in per cent, of times in s.
BEGIN {
    FS = OFS = "\t"
    about["rise"] = "time, pressure above 500 Pa"
    about["impulse"] = "impulse of 0.1 s from 0.01 s before"
    about["peak"] = "peak of the average over 1 ms"
    about["mean20ms"] = "largest mean over 20 ms"
    about["mean40ms"] = "largest mean over 40 ms"
}

/^#/ { next }

{
    impact = substr($1, length($1))
    what = substr($1, 1, length($1) - 1)
    members = $3 + $4
    mean = sprintf("%.4g +- %.2g %s%s", $5, $6, $2, $4 > 0 ? sprintf(" (%d of %d have none)", $4, members) : "")
    reference = $8 ($9 ~ /^[0-9]/ ? " +- " $9 : "") " " $2
    error = what == "rise" ? sprintf("%.3g +- %.2g s", $10, $7) : sprintf("%.3g +- %.2g %%", 100*$10/$8, 100*$7/$8)
    print "mean of " members " spacings, impact " impact ": " about[what], mean, reference, error, $13
}
