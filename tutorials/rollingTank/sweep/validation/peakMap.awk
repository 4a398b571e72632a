# SPDX-License-Identifier: GPL-3.0-or-later
# The mean peaks of all cases, both walls together, with the standard error of the mean, from the sweep's table.
# awk -f validation/peakMap.awk sweep.tsv
BEGIN {
    FS = "\t"
    print "# angle [deg]  omega [rad/s]  D/dx  mean peak [Pa]  +-  left  right  linear theory"
}

NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }

{
    left = $column["left [Pa]"]
    right = $column["right [Pa]"]
    printf "%7d %13d %11d %13.0f %7.0f %7.0f %6.0f %10.0f\n", $column["angle [deg]"], $column["frequency [rad/s]"],
        0.155/$column["spacing [m]"] + 0.5, (left + right)/2, sqrt($column["left +-"]^2 + $column["right +-"]^2)/2, left, right,
        $column["linear reference"]
}
