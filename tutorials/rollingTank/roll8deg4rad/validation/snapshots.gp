# SPDX-License-Identifier: GPL-3.0-or-later
# Liquid and tank at four instants in the inertial frame, coloured by pressure.
# From the case's directory, after particlesToVTK -format csv: gnuplot validation/snapshots.gp
reset
set terminal pngcairo size 1500,1130 font "DejaVu Sans,15"
set output "validation/snapshots.png"

set datafile separator ","
radius = 0.0064     # of a dot: more than half a spacing, so that the liquid looks filled, [m]
instants = "18.5 19 19.5 20"

set size ratio -1
set xrange [-0.56:0.56]
set yrange [-0.09:0.73]
set cbrange [0:2500]
set palette defined (0 "#08306b", 1 "#2171b5", 2 "#6baed6", 3 "#fdd49e", 4 "#ef6548", 5 "#990000")
set colorbox user origin 0.92,0.12 size 0.018,0.76
set cblabel "pressure [Pa]"
set xlabel "y [m]" offset 0,0.5
set ylabel "z [m]" offset 1,0
set style fill solid noborder
unset key

set multiplot layout 2,2 title "Rolling tank: 8 deg, 4 rad/s, liquid depth 0.155 m" \
    margins 0.06,0.89,0.07,0.92 spacing 0.07,0.10
do for [instant in instants] {
    folder = "postProcessing/particles/" . instant . "/"
    set title sprintf("t = %s s, roll %.1f deg", instant, 8*sin(4*instant)) offset 0,-0.6
    plot folder . "fluid.csv" skip 1 using 2:3:(radius):7 with circles linecolor palette, \
         folder . "tank.csv" skip 1 using 2:3 with lines linewidth 3 linecolor rgb "black"
    unset colorbox
}
unset multiplot
