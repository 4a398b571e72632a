# SPDX-License-Identifier: GPL-3.0-or-later
# Pressure averaged over 1 ms, five samples, for the picture: time [s], pressure [Pa].
/^#/ { next }

{
    t[n % 5] = $1
    p[n % 5] = $2
    if (++n >= 5) print t[(n - 3) % 5], (p[0] + p[1] + p[2] + p[3] + p[4])/5
}
