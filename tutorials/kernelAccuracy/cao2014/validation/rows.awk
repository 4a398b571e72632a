# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of results.tsv from what kernelAccuracy wrote and compareTable.awk made of it.
#   awk -f rows.awk kernelAccuracy.txt cao2014_table.csv regular2D.dat regular3D.dat perturbed2D.dat
function row(what, figure, reference, error, source) { printf "%s\t%s\t%s\t%s\t%s\n", what, figure, reference, error, source }
function size(x) { return x < 0 ? -x : x }
function tabulated(d) { return size(10*d - int(10*d + 0.5)) < 1e-9 }     # the table's displacements: 0, 0.1 ... 0.5 dx
# The largest in size of one kernel's column over them, with its sign.
function largest(lattice, column,   i, x, most) {
    for (i = 1; i <= rows[lattice]; ++i) {
        x = value[lattice, column, i]
        if (size(x) > size(most)) most = x
    }
    return most + 0
}
FNR == 1 { lattice = FILENAME; sub(/.*\//, "", lattice); sub(/\.dat$/, "", lattice) }
lattice == "kernelAccuracy.txt" {
    if (match($0, /difference: [0-9.e+-]+/)) inDouble = substr($0, RSTART + 12, RLENGTH - 12)
    if (match($0, /precision, [0-9.e+-]+/)) inLoop = substr($0, RSTART + 11, RLENGTH - 11)
    next
}
lattice == "cao2014_table.csv" {
    split($0, part, ",")
    if (part[1] !~ /^#|^kernel/ && size(part[4]) > size(stated[part[1]])) stated[part[1]] = part[4]
    next
}
/^#/ { for (i = 3; i <= NF; ++i) name[i - 1] = $i; next }    # the last of them names the columns
tabulated($1) {
    ++rows[lattice]
    for (i = 2; i <= NF; ++i) value[lattice, name[i], rows[lattice]] = $i
}
END {
    figs = "Cao et al. 2014, Figs 2 and 3, recomputed"
    row("Largest difference from 48 values of f [m^2], df/dx [m], double precision", inDouble, "0", inDouble, figs)
    row("Largest difference from 48 values of f [m^2], df/dx [m], solver's pair loop", inLoop, "0", inLoop, figs)
    kernels = split("cubicSpline wendlandC2 quinticSpline improvedGaussian", kernel, " ")
    for (k = 1; k <= kernels; ++k) {
        found = largest("regular2D", kernel[k] ":dfdx")
        row("2D, h = 1.23 dx, " kernel[k] ": largest error of df/dx = 2 m", sprintf("%.4f m", found), \
            sprintf("%.4f m", stated[kernel[k]]), sprintf("%.1g m", found - stated[kernel[k]]), figs)
    }
    for (k = 1; k <= kernels; ++k)
        row("3D, h = dx, " kernel[k] ": largest error of df/dx = 2 m", \
            sprintf("%.4f m", largest("regular3D", kernel[k] ":dfdx")), "-", "-", "")
    for (k = 1; k <= kernels; ++k) {
        row("2D perturbed by up to 0.1 dx, " kernel[k] ": largest standard deviation of f", \
            sprintf("%.3f m^2", largest("perturbed2D", kernel[k] ":deviationF")), "-", "-", "")
        row("2D perturbed by up to 0.1 dx, " kernel[k] ": largest standard deviation of df/dx", \
            sprintf("%.2f m", largest("perturbed2D", kernel[k] ":deviationDfdx")), "-", "-", "")
    }
}
