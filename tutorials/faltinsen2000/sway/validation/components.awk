# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of the table of results from what twoSinusoids.awk and crests.awk have printed: name, ours, theirs, ideal, crests.
function row(what, figure, unit, reference, source)
{
    printf "%s: %s\t%.4g%s\t%.4g%s\t%.3g %%\t%s\n", name, what, figure, unit, reference, unit, 100 * (figure / reference - 1), source
}

function sameFit(other, source,    b)
{
    split(other, b, " ")
    row("forced component, the same fit of both", a[1], " m", b[1], source)
    row("free component, the same fit of both", a[2], " m", b[2], source)
    row("beat period, the same fit of both", a[3], " s", b[3], source)
}

BEGIN {
    split(ours, a, " ")
    row("forced component of the gauge", a[1], " m", 0.0637, "Faltinsen et al. 2000; linear theory: 0.0683 m")
    row("beat period", a[3], " s", 5.9, "Faltinsen et al. 2000")
    if (theirs != "absent") sameFit(theirs, "measured record")
    sameFit(ideal, "nonlinear potential flow from the same start")
    if (crests != "absent") {
        split(crests, c, " ")
        printf "%s: delay of %d crests, mean (root mean square)\t%.3f s (%.3f s)\t0\t%.2g %% of a period\tmeasured record, points 0.01 to 0.2 s apart\n", \
            name, c[1], c[2], c[3], 100 * c[2] / 1.3
        row("mean height of these crests over the record's", c[4], "", 1, "measured record; an ideal start gives more")
    }
}
