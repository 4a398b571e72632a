# SPDX-License-Identifier: GPL-3.0-or-later
# Pressure averaged over n samples, for the pictures: time [s], pressure [Pa]. Of samples every 0.2 ms five make 1 ms, of a
# record of 20 kHz twenty. Where the record has a gap, an empty line.
#     awk [-F ,] [-v n=5] -f average.awk <file>
BEGIN { if (!n) n = 5 }

!/^ *[-0-9]/ { next }

{
    if (count && $1 - before > 2e-3)
    {
        print ""
        count = 0
    }
    before = $1
    t[count % n] = $1
    p[count % n] = $2
    if (++count >= n)
    {
        sum = 0
        for (k = 0; k < n; ++k) sum += p[k]
        print (t[count % n] + $1)/2, sum/n
    }
}
