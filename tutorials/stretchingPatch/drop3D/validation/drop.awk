# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of results.tsv that need more than one series or run: strain of the axes, its observed order, volume and energy.
#   awk -f drop.awk <runs of rising R/dx ...> <run with h = dx>
# The lattice's sphere is not quite of the radius R, so axes are taken over their own at the start. SPH sums the density of a
# lattice stretched by c along z, spacing c dx, too high by the share 2 exp(-(pi h/(c dx))^2) (Poisson's sum of the Gaussian):
# the liquid swells by as much at any resolution, 23 % by A0 t = 1 with h = dx, 1.5 % with h = 1.5 dx; by A0 t = 0.5, 3 % and
# 0.02 %.
function row(what, figure, reference, error, source) { printf "%s\t%s\t%s\t%s\t%s\n", what, figure, reference, error, source }
function percent(x) { return sprintf("%.3g %%", 100*x) }
function read(run, axis,   file, line, part, first) {
    file = run "/postProcessing/compareSamples/" axis ".dat"
    while ((getline line < file) > 0) {
        if (line ~ /^#/) continue
        split(line, part, " ")
        if (first == "") first = part[2]
        stretch[run, axis, part[1]] = part[2]/first
        error[run, axis, part[1]] = part[2]/first/part[3] - 1
    }
    close(file)
}
function readEnergy(run,   file, line, part, first) {
    file = run "/postProcessing/energies/0/energies.dat"
    while ((getline line < file) > 0) {
        if (line ~ /^#/) continue
        split(line, part, " ")
        if (first == "") first = part[3] + part[5]
        lost[run] = 1 - (part[3] + part[5])/first
    }
    close(file)
}
function radius(run,   file, line, part, n) {
    file = run "/system/variation"
    while ((getline line < file) > 0)
        if (match(line, /radius +[0-9]+/)) n = substr(line, RSTART + 6, RLENGTH - 6) + 0
    close(file)
    return n
}
# Errors of one axis at a time, and their order.
function orders(axis, t,   i, e, before) {
    for (i = 1; i < runs; ++i) {
        e = error[ARGV[i], axis, t]
        row(sprintf("R/dx = %d, h/dx = 1.5: error of %s/%s(0) at A0 t = %s", n[i], axis, axis, t), percent(e), "0", \
            percent(e), "exact")
        if (i > 1)
            row(sprintf("R/dx = %d to %d: order of the error of %s/%s(0) at A0 t = %s", n[i - 1], n[i], axis, axis, t), \
                before/e > 1 ? sprintf("%.2f", log(before/e)/log(n[i]/n[i - 1])) : "none: swelling", "-", "-", "")
        before = e
    }
}
function swelling(run, n,   swollen, lattice) {
    swollen = stretch[run, "a", 1]^2*stretch[run, "c", 1] - 1
    lattice = 2*exp(-(3.14159265358979/stretch[run, "c", 1])^2)
    row(sprintf("R/dx = %d, h/dx = 1: volume gained by A0 t = 1", n), percent(swollen), percent(lattice), \
        percent(swollen - lattice) " of the volume", "Gaussian's sum over the stretched lattice")
}
BEGIN {
    for (i = 1; i < ARGC; ++i) {
        n[i] = radius(ARGV[i])
        read(ARGV[i], "a"); read(ARGV[i], "c"); readEnergy(ARGV[i])
    }
    runs = ARGC - 1
    split("a c", axes, " ")
    split("0.5 1", times, " ")
    for (t = 1; t <= 2; ++t)
        for (k = 1; k <= 2; ++k) orders(axes[k], times[t])
    for (i = 1; i < runs; ++i)
        row(sprintf("R/dx = %d, h/dx = 1.5: energy lost by A0 t = 1", n[i]), percent(lost[ARGV[i]]), "0", \
            percent(lost[ARGV[i]]), "exact")
    swelling(ARGV[runs], n[runs])
}
