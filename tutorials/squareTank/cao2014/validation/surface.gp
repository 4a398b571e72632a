# SPDX-License-Identifier: GPL-3.0-or-later
# The free surface at three instants without and with baffle, after probeSample with the dictionary of surfaceDict.awk.
# From the case's directory: gnuplot -e "runs = 'runs'" validation/surface.gp
reset
set terminal pngcairo size 1800,1200 font "DejaVu Sans,15" linewidth 1.2
set output "validation/surface.png"

sampled(case, t) = sprintf("< awk -v time=%s -f validation/surface.awk %s/%s/%s", \
    t, runs, case, "postProcessing/probeSample/surface/3.5/height.dat")
half = 0.295
set view 50,335,0.97,1.05
set xyplane at -0.1
set xrange [-half:half]
set yrange [-half:half]
set zrange [-0.1:0.1]
set cbrange [-0.08:0.08]
set palette defined (0 "#08306b", 1 "#6baed6", 2 "#f7f7f7", 3 "#f4a582", 4 "#990000")
set colorbox user origin 0.945,0.3 size 0.01,0.4
set xtics -0.2,0.2 offset 0,-0.3
set ytics -0.2,0.2 offset 0.5,0
set ztics -0.1,0.1
set xlabel "x [m]"
set ylabel "y [m]"
set grid x y z vertical linetype 1 linewidth 0.5 linecolor rgb "#cccccc"
set border 31 linewidth 0.5
unset key
set pm3d depthorder border linewidth 0.3 linecolor rgb "#555555"

set multiplot layout 2,3 title "Elevation of the free surface [m]; the tank moves along the diagonal (- -) to (+ +); the baffle is at x = 0"
do for [case in "open baffle"] {
    do for [t in "3.5 4 12.5"] {
        set title sprintf("%s, t = %s s", case eq "open" ? "without baffle" : "with baffle", t)
        splot sampled(case, t) using 1:2:3 with pm3d
        unset colorbox
    }
}
unset multiplot
