# SPDX-License-Identifier: GPL-3.0-or-later
# Vorticity and velocity at the tip of the baffle of half the depth, at six instants of the last period, in the tank's frame.
# From the case's directory, after particlesToVTK -format csv -frame tank -fields '(U vorticity)':
#     gnuplot -e "runs='runs/quick'; dx=0.01; instants='24.1 24.3 24.4 24.6 24.7 24.9'" validation/flow.gp
reset
set terminal pngcairo size 1500,930 font "DejaVu Sans,14"
set output "validation/flow.png"

height = 0.15       # of the baffle, [m]
seconds = 0.25      # an arrow is the way of so long a time, [s]
csv(instant) = runs . "/d0.5/postProcessing/particles/" . instant . "/fluid.csv"

set datafile separator ","
set size ratio -1
set xrange [-0.12:0.12]
set yrange [0.06:0.26]
set xtics 0.05
set ytics 0.05
set cbrange [-6:6]
set palette defined (-6 "#08306b", -3 "#4292c6", 0 "#f2f2f2", 3 "#ef6548", 6 "#990000")
set colorbox user origin 0.93,0.12 size 0.016,0.76
set cblabel "vorticity [1/s], positive: clockwise"
set xlabel "x [m]" offset 0,0.5
set object 1 rectangle from -0.02,0 to 0.02,height fillcolor rgb "#666666" fillstyle solid noborder
set style fill solid noborder
unset key

set multiplot layout 2,3 title "Baffle height d = 0.5 D: vorticity and velocity at its tip at six instants of a period" \
    margins 0.06,0.91,0.08,0.90 spacing 0.04,0.12
do for [i = 1:words(instants)] {
    instant = word(instants, i)
    if (i % 3 == 1) { set ylabel "z [m]" offset 1,0 } else { unset ylabel }
    set title sprintf("%.2f s, velocity of the tank %+.1f mm/s", 1.0*instant, 1000*0.0024*6.8636*cos(6.8636*instant)) offset 0,-0.6
    plot csv(instant) skip 1 using 1:3:(0.65*dx):8 with circles linecolor palette, \
         csv(instant) skip 1 using 1:3:(seconds*$4):(seconds*$6) with vectors head size 0.004,20 filled linewidth 1 linecolor rgb "#222222"
    unset colorbox
}
unset multiplot
