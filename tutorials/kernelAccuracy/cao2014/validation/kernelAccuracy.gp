# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of f and df/dx over the displacement of the probe, for the three lattices.
# From the case's directory: gnuplot validation/kernelAccuracy.gp
reset
set terminal pngcairo size 2000,1560 font "DejaVu Sans,15" linewidth 1.5
set output "validation/kernelAccuracy.png"

folder = "postProcessing/kernelAccuracy/"
array kernel[4] = ["cubicSpline", "wendlandC2", "quinticSpline", "improvedGaussian"]
array title[4] = ["cubic spline", "Wendland C2", "quintic spline", "improved Gaussian"]
array colour[4] = ["#0b5fa5", "#b5480f", "#1b7f3b", "#7a3b9a"]
regular(k, c) = 6*(k - 1) + c       # columns of the files: 2 f, 3 df/dx, 6 and 7 those of the pair loop,
perturbed(k, c) = 9*(k - 1) + c     # 8 and 9 the deviations

set xrange [0:0.5]
set xtics 0.1
set xlabel "displacement of the probe along the diagonal, d/dx" offset 0,0.4
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set xzeroaxis linetype 1 linewidth 0.7 linecolor rgb "black"
unset key
set multiplot layout 3,3 title "Kernel sums of f = x^2 + y^2 (+ z^2) over a square (cube) of edge 2 m, dx = 0.1 m; \
in its middle f = 2 m^2 (3 m^2), df/dx = 2 m\n{/*0.85 lines: double precision; crosses: the solver's pair loop in single precision; \
circles: Cao et al. 2014, Figs 2 and 3, recomputed}" margins 0.065,0.985,0.05,0.905 spacing 0.07,0.095

do for [row in "1 3"] {
    file = folder . (row == 1 ? "regular2D.dat" : "regular3D.dat")
    name = row == 1 ? "2D regular, h = 1.23 dx" : "3D regular, h = dx"
    if (row == 3) {
        # The perturbed lattice, in the row between.
        file2 = folder . "perturbed2D.dat"
        name2 = "2D perturbed by up to 0.1 dx"
        unset key
        set title name2 . ": mean error of f" offset 0,-0.6
        set ylabel "error of f [m^2]" offset 1,0
        plot for [k = 1:4] file2 using 1:perturbed(k, 2) with lines linecolor rgb colour[k], \
             for [k = 1:4] file2 using 1:perturbed(k, 6) with points pointtype 2 linecolor rgb colour[k]
        set title name2 . ": mean error of df/dx"
        set ylabel "error of df/dx [m]"
        plot for [k = 1:4] file2 using 1:perturbed(k, 3) with lines linecolor rgb colour[k], \
             for [k = 1:4] file2 using 1:perturbed(k, 7) with points pointtype 2 linecolor rgb colour[k]
        set title name2 . ": standard deviation"
        set ylabel "standard deviation [m], [m^2]"
        set yrange [0:1.8]
        set key top right samplen 2
        plot for [k = 1:4] file2 using 1:perturbed(k, 9) with lines linecolor rgb colour[k] notitle, \
             for [k = 1:4] file2 using 1:perturbed(k, 8) with lines dashtype 2 linecolor rgb colour[k] notitle, \
             NaN with lines linecolor rgb "black" title "df/dx", NaN with lines dashtype 2 linecolor rgb "black" title "f"
        set yrange [*:*]
        unset key
    }
    set title name . ": error of f" offset 0,-0.6
    set ylabel "error of f [m^2]" offset 1,0
    if (row == 1) { set key top right samplen 2 }
    plot for [k = 1:4] file using 1:regular(k, 2) with lines linecolor rgb colour[k] title title[k], \
         for [k = 1:4] file using 1:regular(k, 6) with points pointtype 2 linecolor rgb colour[k] notitle, \
         for [k = 1:4] "validation/kernelAccuracy.txt" using 2:(row == 1 && strcol(1) eq kernel[k] ? $3 : NaN) \
             with points pointtype 6 pointsize 2 linecolor rgb colour[k] notitle
    unset key
    do for [zoom = 0:1] {
        set title name . ": error of df/dx" . (zoom ? ", enlarged" : "")
        set ylabel "error of df/dx [m]"
        if (zoom && row == 1) { set yrange [-0.012:0.012] }
        if (zoom && row == 3) { set yrange [-0.03:0.03] }
        plot for [k = 1:4] file using 1:regular(k, 3) with lines linecolor rgb colour[k], \
             for [k = 1:4] file using 1:regular(k, 7) with points pointtype 2 linecolor rgb colour[k], \
             for [k = 1:4] "validation/kernelAccuracy.txt" using 2:(row == 1 && strcol(1) eq kernel[k] ? $6 : NaN) \
                 with points pointtype 6 pointsize 2 linecolor rgb colour[k]
        set yrange [*:*]
    }
}
unset multiplot
