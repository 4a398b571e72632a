# The mean of the highest pressure per period, over the whole periods between 10 and 20 s, for each probe.
BEGIN {
    period = 2 * 3.14159265358979 / 4   # omega = 4 rad/s
    begin = 10
    n = int((20 - begin) / period)
}

/^#/ { next }

{
    probes = NF - 1
    k = int(($1 - begin) / period)
    if ($1 < begin || k >= n) next
    for (i = 1; i <= probes; ++i)
        if (!((i, k) in peak) || $(i + 1) > peak[i, k]) peak[i, k] = $(i + 1)
}

END {
    printf "# Mean of the highest pressure per period, %d periods from %g s on\n", n, begin
    printf "# interFoam (1 cm cells): 3.9 to 4.9 kPa\n"
    printf "# probe    mean [Pa]   lowest [Pa]  highest [Pa]\n"
    for (i = 1; i <= probes; ++i) {
        sum = 0
        for (k = 0; k < n; ++k) {
            if (!((i, k) in peak)) {
                print "no sample of probe " i - 1 " in period " k + 1 > "/dev/stderr"
                exit 1
            }
            sum += peak[i, k]
            if (k == 0 || peak[i, k] < low) low = peak[i, k]
            if (k == 0 || peak[i, k] > high) high = peak[i, k]
        }
        printf "%7d %12.1f %13.1f %13.1f\n", i - 1, sum / n, low, high
    }
}
