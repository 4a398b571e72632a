# SPDX-License-Identifier: GPL-3.0-or-later
# Elevations and pressures without and with baffle, and linear theory.
# From the case's directory: gnuplot -e "runs = 'runs'" validation/histories.gp
reset
set terminal pngcairo size 1600,1700 font "DejaVu Sans,15" linewidth 1.4
set output "validation/histories.png"

open = runs . "/open/postProcessing/"
baffle = runs . "/baffle/postProcessing/"
alpha0 = runs . "/alpha0/postProcessing/"
still = 0.29972
blue = "#0b5fa5"
red = "#b5480f"

set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set multiplot layout 5,1 title "Square tank, 0.59 m, depth 0.2997 m: sway and surge along the diagonal, 4.6 mm, 7.63 rad/s" \
    margins 0.07,0.98,0.04,0.94 spacing 0.055
set key top left horizontal samplen 2
set ylabel "elevation [m]" offset 0.5,0

set title "P1, 0.04 m from the wall parallel to the baffle: first periods" offset 0,-0.7
set xrange [0:3]
set yrange [-0.045:0.06]
plot open . "compareSamples/early.dat" using 1:3 with lines linecolor rgb "black" title "linear theory", \
     open . "gauges/0/height.dat" using 1:($2 - still) with lines linecolor rgb blue title "without baffle", \
     alpha0 . "gauges/0/height.dat" using 1:($2 - still) with lines dashtype 2 linecolor rgb blue title "without baffle, alpha = 0", \
     baffle . "gauges/0/height.dat" using 1:($2 - still) with lines linecolor rgb red title "with baffle"

set title "P1"
set xrange [0:18]
plot open . "compareSamples/P1.dat" using 1:3 with lines linewidth 0.7 linecolor rgb "#999999" \
         title "linear theory (no damping)", \
     open . "gauges/0/height.dat" using 1:($2 - still) with lines linecolor rgb blue title "without baffle", \
     baffle . "gauges/0/height.dat" using 1:($2 - still) with lines linecolor rgb red title "with baffle"

set title "Corners: solid (+ +), in the direction of the motion; dashed (+ -)"
set yrange [-0.08:0.12]
plot open . "gauges/0/height.dat" using 1:($6 - still) with lines linecolor rgb blue title "without baffle", \
     baffle . "gauges/0/height.dat" using 1:($6 - still) with lines linecolor rgb red title "with baffle", \
     open . "gauges/0/height.dat" using 1:($10 - still) with lines dashtype 2 linecolor rgb blue notitle, \
     baffle . "gauges/0/height.dat" using 1:($10 - still) with lines dashtype 2 linecolor rgb red notitle

set ylabel "pressure [kPa]" offset 0.5,0
set title "P2, wall at the still water level"
set yrange [-0.05:0.45]
set ytics 0.1
plot open . "pressure/0/p" using 1:($2/1000) with lines linecolor rgb blue title "without baffle", \
     baffle . "pressure/0/p" using 1:($2/1000) with lines linecolor rgb red title "with baffle"

set title "P3, wall 0.15 m above the bottom"
set xlabel "time [s]" offset 0,0.6
set yrange [1.1:1.9]
set ytics 0.2
plot open . "pressure/0/p" using 1:($3/1000) with lines linecolor rgb blue title "without baffle", \
     baffle . "pressure/0/p" using 1:($3/1000) with lines linecolor rgb red title "with baffle"
unset multiplot
