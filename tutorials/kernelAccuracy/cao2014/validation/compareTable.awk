# SPDX-License-Identifier: GPL-3.0-or-later
# The values of a table of kernel,dByDx,f,dfdx beside those kernelAccuracy wrote: in double precision and of the solver's
# pair loop. Exit status 1 where one differs by `tolerance` or more, or is not there.
#   awk -v tolerance=1e-4 -f compareTable.awk cao2014_table.csv regular2D.dat
function key(displacement, name) { return sprintf("%.6f %s", displacement, name) }
function off(x, y) { return x > y ? x - y : y - x }

FILENAME == ARGV[1] {
    if ($0 !~ /^#/ && $0 !~ /^kernel/) {
        split($0, field, ",")
        ++rows
        kernel[rows] = field[1]; d[rows] = field[2]; table["f", rows] = field[3]; table["dfdx", rows] = field[4]
    }
    next
}
/^#/ { for (i = 3; i <= NF; ++i) column[i - 1] = $i; next }   # the last of them names the columns
{ for (i = 2; i <= NF; ++i) found[key($1, column[i])] = $i }

END {
    print "# Errors of f [m^2] and df/dx [m], d/dx of the diagonal; Cao et al. 2014, Figs 2 and 3"
    printf "#%16s %5s %10s %12s %12s %10s %12s %12s\n", "kernel", "d/dx", "f: table", "double", "pair loop", \
        "df/dx:", "double", "pair loop"
    for (k = 1; k <= rows; ++k) {
        printf "%17s %5.2f", kernel[k], d[k]
        for (q = 1; q <= 2; ++q) {
            quantity = q == 1 ? "f" : "dfdx"
            printf " %10.5f", table[quantity, k]
            for (c = 1; c <= 2; ++c) {
                name = c == 1 ? quantity : (q == 1 ? "loopF" : "loopDfdx")
                at = key(d[k], kernel[k] ":" name)
                if (!(at in found)) { printf "\n# %s is not there\n", at; exit 1 }
                printf " %12.7f", found[at]
                difference = off(found[at], table[quantity, k])
                if (difference > largest[c]) largest[c] = difference
                ++values[c]
            }
        }
        print ""
    }
    good = rows > 0 && largest[1] < tolerance && largest[2] < tolerance
    printf "# %d values; largest absolute difference: %.2e in double precision, %.2e of the pair loop: %s %g\n", \
        values[1], largest[1], largest[2], good ? "below" : "NOT below", tolerance
    exit !good
}
