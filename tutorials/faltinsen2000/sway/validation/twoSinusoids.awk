# SPDX-License-Identifier: GPL-3.0-or-later
# Least-squares fit of a record by its mean, the forced oscillation and a free one:
#     eta = a0 + a1 cos(omega t) + b1 sin(omega t) + a2 cos(s t) + b2 sin(s t),   omega = 2 pi/period,
# with the free frequency s that leaves the smallest residual among 0.6 to 0.95 omega. Prints
#     forced amplitude, free amplitude, beat period 2 pi/(omega - s), residual (root mean square).
# Without a record of samples it prints nothing and ends with status 1.
#     awk -v period=1.3 -v begin=0 -v end=10 -v column=2 -v offset=0 -f twoSinusoids.awk record
BEGIN {
    FS = "[ \t,]+"
    pi = atan2(0, -1)
    omega = 2 * pi / period
}

/^[ \t]*[-+0-9.]/ {
    shift = $1 == "" ? 1 : 0
    x = $(1 + shift) + 0
    if (x < begin || x > end) next
    t[n] = x
    eta[n++] = $(column + shift) + offset
}

# Fits with the free frequency s; leaves the coefficients in c and returns the sum of squares.
function fit(s,    i, j, k, base, A, y, factor, sum, off)
{
    for (j = 0; j < 5; ++j) {
        y[j] = 0
        for (k = 0; k < 5; ++k) A[j, k] = 0
    }
    for (i = 0; i < n; ++i) {
        base[0] = 1
        base[1] = cos(omega * t[i]); base[2] = sin(omega * t[i])
        base[3] = cos(s * t[i]);     base[4] = sin(s * t[i])
        for (j = 0; j < 5; ++j) {
            y[j] += base[j] * eta[i]
            for (k = 0; k < 5; ++k) A[j, k] += base[j] * base[k]
        }
    }
    for (j = 0; j < 5; ++j)
        for (k = j + 1; k < 5; ++k) {
            factor = A[k, j] / A[j, j]
            for (i = j; i < 5; ++i) A[k, i] -= factor * A[j, i]
            y[k] -= factor * y[j]
        }
    for (j = 4; j >= 0; --j) {
        c[j] = y[j]
        for (k = j + 1; k < 5; ++k) c[j] -= A[j, k] * c[k]
        c[j] /= A[j, j]
    }
    sum = 0
    for (i = 0; i < n; ++i) {
        off = eta[i] - c[0] - c[1] * cos(omega * t[i]) - c[2] * sin(omega * t[i]) - c[3] * cos(s * t[i]) - c[4] * sin(s * t[i])
        sum += off * off
    }
    return sum
}

END {
    if (n < 20) {
        print "twoSinusoids.awk: only " n + 0 " samples" > "/dev/stderr"
        exit 1
    }
    for (ratio = 0.6; ratio <= 0.95; ratio += 0.001) {
        sum = fit(ratio * omega)
        if (best == "" || sum < best) {
            best = sum
            free = ratio * omega
        }
    }
    best = fit(free)
    printf "%.5f %.5f %.3f %.5f\n", sqrt(c[1]^2 + c[2]^2), sqrt(c[3]^2 + c[4]^2), 2 * pi / (omega - free), sqrt(best / n)
}
