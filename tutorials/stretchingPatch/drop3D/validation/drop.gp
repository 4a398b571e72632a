# SPDX-License-Identifier: GPL-3.0-or-later
# Semi-axes, their errors and the pressure in the centre, of all runs and exact.
# From the case's directory: gnuplot -e "prefix = 'runs/'; spacings = '8 12 16'" validation/drop.gp
reset
set terminal pngcairo size 1500,1300 font "DejaVu Sans,15" linewidth 1.5
set output "validation/drop.png"

array colour[4] = ["#7a3b9a", "#1b7f3b", "#0b5fa5", "#b5480f"]
finest = word(spacings, words(spacings))
file(name, series) = prefix . name . "/postProcessing/compareSamples/" . series . ".dat"
error(name, series) = sprintf("< awk '/^#/ { next } !first { first = $2 } { print $1, 100*($2/first/$3 - 1) }' %s", \
    file(name, series))

set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set xrange [0:1]
set multiplot layout 3,1 title "Drop stretched by v = A_0(-x/2, -y/2, z), R = 1 m, A_0 = 1/s, p_0 = 250 Pa in the centre" \
    margins 0.08,0.98,0.055,0.94 spacing 0.07
set ylabel "semi-axes a, c [m]"
set key top left
plot file(finest, "a") using 1:3 with lines linecolor rgb "black" title "exact", \
     file(finest, "c") using 1:3 with lines linecolor rgb "black" notitle, \
     for [i = 1:words(spacings)] file(word(spacings, i), "a") with points pointtype 4 + 2*i linecolor rgb colour[i] \
         title "R/dx = " . word(spacings, i) . ", h/dx = 1.5", \
     for [i = 1:words(spacings)] file(word(spacings, i), "c") with points pointtype 4 + 2*i linecolor rgb colour[i] notitle, \
     for [s in "a c"] file("12h1", s) with points pointtype 2 linecolor rgb "#888888" \
         title s eq "a" ? "R/dx = 12, h/dx = 1" : ""
set ylabel "error of a/a(0), c/c(0) [%]"
set yrange [-1.5:1.5]
plot for [i = 1:words(spacings)] error(word(spacings, i), "a") with lines dashtype 2 linecolor rgb colour[i] notitle, \
     for [i = 1:words(spacings)] error(word(spacings, i), "c") with lines linecolor rgb colour[i] notitle, \
     error("12h1", "a") with lines dashtype 2 linecolor rgb "#888888" notitle, \
     error("12h1", "c") with lines linecolor rgb "#888888" notitle, \
     NaN with lines linecolor rgb "black" title "c", NaN with lines dashtype 2 linecolor rgb "black" title "a"
set yrange [-100:500]
set key top right
set xlabel "A_0 t"
set ylabel "pressure in the centre [Pa]"
plot for [i = 1:words(spacings)] file(word(spacings, i), "p") with lines linewidth 0.8 linecolor rgb colour[i] \
         title "R/dx = " . word(spacings, i), \
     file(finest, "p") using 1:3 with lines linewidth 1.5 linecolor rgb "black" title "exact"
unset multiplot
