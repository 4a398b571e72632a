# SPDX-License-Identifier: GPL-3.0-or-later
# When and how high the crests of a record are in samples: for each crest of the record (its highest point within half a
# period on both sides, above `least`) the highest sample within a quarter period. Prints
#     number of crests, mean delay of the samples' crests [s], its root mean square [s], mean height over the record's.
# awk -v period=1.3 -v least=0.02 -v offset=-0.6 -f crests.awk record samples
BEGIN { FS = "[ \t,]+" }

/^[ \t]*[-+0-9.]/ {
    shift = $1 == "" ? 1 : 0
    if (FNR == NR) {
        t[n] = $(1 + shift) + 0
        eta[n++] = $(2 + shift) + 0
    } else {
        s[m] = $(1 + shift) + 0
        level[m++] = $(2 + shift) + offset
    }
}

END {
    for (i = 0; i < n; ++i) {
        if (eta[i] < least || t[i] + period / 4 > s[m - 1]) continue
        isCrest = 1
        for (j = 0; j < n; ++j)
            if (t[j] > t[i] - period / 2 && t[j] < t[i] + period / 2 && eta[j] > eta[i]) isCrest = 0
        if (!isCrest || t[i] - last < period / 2) continue
        last = t[i]
        highest = -1
        for (j = 0; j < m; ++j)
            if (s[j] > t[i] - period / 4 && s[j] < t[i] + period / 4 && level[j] > highest) {
                highest = level[j]
                at = s[j]
            }
        ++crests
        delay += at - t[i]
        squares += (at - t[i])^2
        ours += highest
        theirs += eta[i]
    }
    if (crests) printf "%d %.4f %.4f %.4f\n", crests, delay / crests, sqrt(squares / crests), ours / theirs
}
