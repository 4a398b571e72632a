# SPDX-License-Identifier: GPL-3.0-or-later
# Semi-axes and central pressure of the four kernels at R/dx = 40 against the exact solution, for both rates.
# From the case's directory: gnuplot validation/patch.gp
reset
set terminal pngcairo size 1800,1000 font "DejaVu Sans,14" linewidth 1.5
set output "validation/patch.png"

kernels = "cubicSpline wendlandC2 quinticSpline improvedGaussian"
colours = "#b5480f #7a4fa3 #2f8f4e #0b5fa5"
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
file(k, A0, what) = sprintf("runs/%s_A%d_40/postProcessing/compareSamples/%s.dat", word(kernels, k), A0, what)
set multiplot layout 2,3 title "Stretching patch, R/dx = 40: exact (black) and four kernels"
do for [A0 = 1:2] {
    set xlabel A0 == 2 ? "A_0 t" : ""
    set title sprintf("A_0 = %d/s", A0) offset 0,-0.6
    set xrange [0:2]
    set yrange [1:4]
    set ylabel "long semi-axis b [m]"
    unset key
    plot for [k = 1:4] file(k, A0, "b") using ($1*A0):2 with lines linecolor rgb word(colours, k), \
        file(4, A0, "b") using ($1*A0):3 with lines dashtype 2 linecolor rgb "black"
    set yrange [0:1]
    set ylabel "short semi-axis a [m]"
    plot for [k = 1:4] file(k, A0, "a") using ($1*A0):2 with lines linecolor rgb word(colours, k), \
        file(4, A0, "a") using ($1*A0):3 with lines dashtype 2 linecolor rgb "black"
    set xrange [0:1]
    set yrange [-0.2:1.7]
    set ylabel "p_c / ({/Symbol r} A_0^2 R^2/2)"
    set key top right
    plot for [k = 1:4] file(k, A0, "p") using ($1*A0):($2/500/A0**2) with lines linecolor rgb word(colours, k) \
        title word(kernels, k), \
        file(4, A0, "p") using ($1*A0):($3/500/A0**2) with lines dashtype 2 linecolor rgb "black" title "exact"
}
unset multiplot
