# SPDX-License-Identifier: GPL-3.0-or-later
# Which of the two waves of a start from rest an error is in: by least squares, the series and its reference as
#   c + forced wave (omega) + free wave (omega1), and what is left.
#     awk -v ratio=<omega/omega1> -v run=<name> -f waves.awk <run>/postProcessing/compareSamples/gauge.dat
# prints: name, amplitudes of the forced and the free wave over those of the reference, the difference of the means and the rest
# over the root mean square of the reference.
BEGIN {
    pi = atan2(0, -1)
    omega1 = sqrt(9.81*pi*(1 - exp(-pi))/(1 + exp(-pi)))
}

!/^#/ {
    ++n
    term[1] = cos(ratio*omega1*$1)
    term[2] = sin(ratio*omega1*$1)
    term[3] = cos(omega1*$1)
    term[4] = sin(omega1*$1)
    term[5] = 1
    for (i = 1; i <= 5; ++i) {
        for (j = 1; j <= 5; ++j) A[i, j] += term[i]*term[j]
        A[i, 6] += term[i]*$2
        A[i, 7] += term[i]*$3
    }
    samples += $2*$2
    reference += $3*$3
    sum += $3
}

function amplitude(column, first) { return sqrt(A[first, column]^2 + A[first + 1, column]^2) }

END {
    for (column = 6; column <= 7; ++column)
        for (i = 1; i <= 5; ++i) right[i, column] = A[i, column]
    # Gauss-Jordan; the terms are far from dependent.
    for (i = 1; i <= 5; ++i) {
        for (j = 7; j >= i; --j) A[i, j] /= A[i, i]
        for (k = 1; k <= 5; ++k)
            if (k != i)
                for (j = 7; j >= i; --j) A[k, j] -= A[k, i]*A[i, j]
    }
    left = samples
    for (i = 1; i <= 5; ++i) left -= A[i, 6]*right[i, 6]
    rms = sqrt(reference/n - (sum/n)^2)
    printf "%-44s %6.3f %6.3f %7.3f %6.3f\n", run, amplitude(6, 1)/amplitude(7, 1), amplitude(6, 3)/amplitude(7, 3), \
        (A[5, 6] - A[5, 7])/rms, sqrt(left/n)/rms
}
