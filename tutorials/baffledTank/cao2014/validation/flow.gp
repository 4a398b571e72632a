# Velocity at the tip of the baffle of half the depth at six instants of the last period, in the tank's frame.
# From the case's directory, after particlesToVTK -format csv -frame tank:
#     gnuplot -e "runs='runs/quick'; instants='24.1,24.3,24.5,24.6,24.8,24.9'" validation/flow.gp
reset
set terminal pngcairo size 1500,1120 font "DejaVu Sans,14"
set output "validation/flow.png"

set datafile separator ","
seconds = 0.25      # an arrow is the way of so long a time, [s]
do for [i = 1:strlen(instants)] { if (instants[i:i] eq ",") { instants = instants[1:i-1] . " " . instants[i+1:*] } }

set size ratio -1
set xrange [-0.15:0.15]
set yrange [0.05:0.29]
set cbrange [0:0.1]
set palette defined (0 "#c6dbef", 1 "#6baed6", 2 "#2171b5", 3 "#08306b", 4 "#ef6548", 5 "#990000")
set colorbox user origin 0.93,0.12 size 0.016,0.76
set cblabel "speed [m/s]"
set xlabel "x [m]" offset 0,0.5
set ylabel "z [m]" offset 1,0
set object 1 rectangle from -0.02,0 to 0.02,0.15 fillcolor rgb "#888888" fillstyle solid noborder
unset key

set multiplot layout 2,3 title "Baffle of half the depth: velocity at its tip, six instants of a period" \
    margins 0.06,0.91,0.06,0.92 spacing 0.05,0.09
do for [instant in instants] {
    set title sprintf("t = %s s, tank's velocity %+.4f m/s", instant, 0.0024*6.8636*cos(6.8636*instant)) offset 0,-0.6
    plot runs . "/d0.5/postProcessing/particles/" . instant . "/fluid.csv" skip 1 \
         using 1:3:(seconds*$4):(seconds*$6):(sqrt($4**2 + $6**2)) with vectors head size 0.004,20 filled linewidth 1.3 linecolor palette
    unset colorbox
}
unset multiplot
