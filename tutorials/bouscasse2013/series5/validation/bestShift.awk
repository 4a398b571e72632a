# SPDX-License-Identifier: GPL-3.0-or-later
# The delay of samples against a record that leaves the smallest difference, looked for between -period/2 and period/2:
#     difference(s) = sqrt(sum (eta(t_i + s) - r_i)^2 / sum (r_i - mean r)^2)
# over the record's points. Prints: delay [s], difference with it, difference without.
# awk -v period=2.99929 -v offset=-0.03 -f bestShift.awk record samples
# The record: comma-separated, elevation in the second column, time in the third; the samples: time, level.
BEGIN { FS = "[ \t,]+" }

/^[ \t]*[-+0-9.]/ {
    shift = $1 == "" ? 1 : 0
    if (FNR == NR) {
        t[n] = $(3 + shift) + 0
        r[n++] = $(2 + shift) + 0
    } else {
        s[m] = $(1 + shift) + 0
        level[m++] = $(2 + shift) + offset
    }
}

# The samples at time x, between the two around it.
function at(x,    low, high, middle)
{
    low = 0
    high = m - 1
    while (high - low > 1) {
        middle = int((low + high) / 2)
        if (s[middle] <= x) low = middle
        else high = middle
    }
    return level[low] + (level[high] - level[low]) * (x - s[low]) / (s[high] - s[low])
}

# Over the points that have samples after the shift; n/2 at least.
function difference(delay,    i, sum, squares, count)
{
    sum = squares = count = 0
    for (i = 0; i < n; ++i) {
        if (t[i] + delay < s[0] || t[i] + delay > s[m - 1]) continue
        ++count
        sum += (at(t[i] + delay) - r[i])^2
        squares += (r[i] - mean)^2
    }
    return count < n / 2 ? 1e9 : sqrt(sum / squares)
}

END {
    for (i = 0; i < n; ++i) mean += r[i] / n
    best = 1e9
    for (delay = -period / 2; delay <= period / 2; delay += 0.005) {
        d = difference(delay)
        if (d < best) {
            best = d
            bestDelay = delay
        }
    }
    printf "%.3f %.4f %.4f\n", bestDelay, best, difference(0)
}
