# SPDX-License-Identifier: GPL-3.0-or-later
# The liquid at four instants, coloured by pressure.
# From the tutorial's directory, after particlesToVTK -format csv: gnuplot -e "run = 'runs/quick'" validation/snapshots.gp
reset
set terminal pngcairo size 1500,720 font "DejaVu Sans,14"
set output "validation/snapshots.png"

set datafile separator ","
radius = run eq "runs/full" ? 0.0026 : 0.0042  # of a dot: more than half a spacing, so that the liquid looks filled, [m]
set size ratio -1
set xrange [-0.02:1.63]
set yrange [-0.02:0.5]
set cbrange [0:2.5]
set palette defined (0 "#08306b", 1 "#2171b5", 2 "#6baed6", 2.6 "#fdd49e", 3.3 "#ef6548", 4 "#990000")
set cblabel "pressure [kPa]"
set colorbox user origin 0.93,0.12 size 0.018,0.76
set xlabel "x [m]" offset 0,0.5
set ylabel "z [m]" offset 1,0
set style fill solid noborder
unset key
set multiplot layout 2,2 title "Dam break, column 0.6 m x 0.3 m" margins 0.06,0.90,0.10,0.92 spacing 0.06,0.10
do for [instant in "0.4 0.5 0.6 0.8"] {
    set title "t = " . instant . " s" offset 0,-0.6
    plot run . "/postProcessing/particles/" . instant . "/fluid.csv" skip 1 using 1:3:(radius):($7/1000) \
        with circles linecolor palette
    unset colorbox
}
unset multiplot
