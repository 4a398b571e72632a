# SPDX-License-Identifier: GPL-3.0-or-later
# Wall pressure over rho g h, and kinetic energy over m g D, in one picture.
# From the case's directory: gnuplot -e 'hydrostatic = <rho g h>; energy = <m g D>' ../validation/stillWater.gp
set terminal pngcairo size 1500,1000 font "DejaVu Sans,15" linewidth 1.5
set output "validation/stillWater.png"

set xrange [0:10]
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set multiplot layout 2,1 title "Still water in a tank at rest" margins 0.1,0.98,0.08,0.92 spacing 0.1

set yrange [*<0.97:1.03<*]
set ylabel "wall pressure / (rho g h)"
set key top right
plot "postProcessing/pressure/0/p" using 1:($2/hydrostatic) with lines linecolor rgb "#0b5fa5" title "probe 0", \
     "" using 1:($3/hydrostatic) with lines linecolor rgb "#b5480f" title "probe 1", \
     1 with lines dashtype 2 linecolor rgb "black" title "exact", \
     1.01 with lines dashtype 3 linecolor rgb "black" title "+-1 %", 0.99 with lines dashtype 3 linecolor rgb "black" notitle

set xlabel "time [s]"
set ylabel "kinetic energy / (m g D)"
set logscale y
set yrange [1e-10:1e-3]
set format y "10^{%L}"
plot "postProcessing/energies/0/energies.dat" using 1:($2/energy) with lines linecolor rgb "#0b5fa5" notitle, \
     1e-4 with lines dashtype 3 linecolor rgb "black" title "bound: 10^{-4}"
unset multiplot
