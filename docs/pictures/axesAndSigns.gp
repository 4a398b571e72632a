# SPDX-License-Identifier: GPL-3.0-or-later
# From docs/pictures/axesAndSigns, which sets `case`: a folder with 0/ and 0.4/, each fluid.csv and tank.csv.
reset
set terminal svg size 1000,460 font "DejaVu Sans,15" background rgb "white"
set output "axesAndSigns.svg"
set multiplot

# Axes, seen from x > 0, y < 0, z > 0, by hand: x towards the reader.
unset border
unset tics
unset key
set size 0.42, 1
set origin 0, 0
set lmargin 0
set rmargin 0
set tmargin 2
set bmargin 0
set size ratio -1
set xrange [-1.5:1.9]
set yrange [-1.5:2.0]
set parametric
set trange [0:1]
set samples 60
px(x, y, z) = -0.55*x + 0.95*y
py(x, y, z) = -0.48*x - 0.12*y + z
set title "positive directions"
ax = 1.35
set arrow 1 from 0,0 to px(ax,0,0),py(ax,0,0) linewidth 2.5 linecolor rgb "#a50b2c"
set arrow 2 from 0,0 to px(0,ax,0),py(0,ax,0) linewidth 2.5 linecolor rgb "#0b7a3b"
set arrow 3 from 0,0 to px(0,0,ax),py(0,0,ax) linewidth 2.5 linecolor rgb "#0b5fa5"
set label 1 "x surge" at px(1.5,0,0)-0.1,py(1.5,0,0)-0.12 center textcolor rgb "#a50b2c"
set label 2 "y sway" at px(0,1.45,0),py(0,1.45,0)-0.02 left textcolor rgb "#0b7a3b"
set label 3 "z heave" at px(0,0,1.5),py(0,0,1.5)+0.05 center textcolor rgb "#0b5fa5"
# Arcs: each from one axis towards the next, y to z about x, z to x about y, x to y about z.
r = 0.75
a(t) = pi/2*(0.12 + 0.70*t)
e = 0.12 + 0.70
f = 0.12 + 0.76
arc(s) = pi/2*s
set arrow 4 from px(0,r*cos(arc(e)),0),py(0,r*cos(arc(e)),r*sin(arc(e))) to px(0,r*cos(arc(f)),0),py(0,r*cos(arc(f)),r*sin(arc(f))) linewidth 2 linecolor rgb "#a50b2c"
set arrow 5 from px(r*sin(arc(e)),0,0),py(r*sin(arc(e)),0,r*cos(arc(e))) to px(r*sin(arc(f)),0,0),py(r*sin(arc(f)),0,r*cos(arc(f))) linewidth 2 linecolor rgb "#0b7a3b"
set arrow 6 from px(r*cos(arc(e)),r*sin(arc(e)),0),py(r*cos(arc(e)),r*sin(arc(e)),0) to px(r*cos(arc(f)),r*sin(arc(f)),0),py(r*cos(arc(f)),r*sin(arc(f)),0) linewidth 2 linecolor rgb "#0b5fa5"
set label 4 "roll" at 0.62,0.62 left textcolor rgb "#a50b2c"
set label 5 "pitch" at -0.42,0.5 right textcolor rgb "#0b7a3b"
set label 6 "yaw" at 0.3,-0.62 left textcolor rgb "#0b5fa5"
plot px(0,r*cos(a(t)),0),py(0,r*cos(a(t)),r*sin(a(t))) with lines linewidth 2 linecolor rgb "#a50b2c", \
     px(r*sin(a(t)),0,0),py(r*sin(a(t)),0,r*cos(a(t))) with lines linewidth 2 linecolor rgb "#0b7a3b", \
     px(r*cos(a(t)),r*sin(a(t)),0),py(r*cos(a(t)),r*sin(a(t)),0) with lines linewidth 2 linecolor rgb "#0b5fa5"

unset parametric
unset arrow
unset label
set size 0.58, 1
set origin 0.42, 0
set lmargin 8
set rmargin 2
set tmargin 2
set bmargin 4
set border 3
set tics nomirror
set xrange [-0.62:0.62]
set yrange [-0.12:0.78]
set xtics 0.2 nomirror
set ytics 0.2 nomirror
set xlabel "y [m], seen from +x: x points at you"
set ylabel "z [m]"
set datafile separator ","
set title "roll of +8 degrees: y = +0.46 m is up"
set label 1 "goes down first" at -0.45,0.70 center
set label 2 "rises" at 0.43,0.755 center
set arrow 1 from -0.52,0.64 to -0.52,0.54 linewidth 2 linecolor rgb "#a50b2c"
set arrow 2 from 0.50,0.60 to 0.50,0.70 linewidth 2 linecolor rgb "#a50b2c"
plot case."/0.4/fluid.csv" using 2:3 skip 1 with points pointtype 7 pointsize 0.35 linecolor rgb "#4a90c8", \
     case."/0/tank.csv" using 2:3 skip 1 with lines dashtype 3 linewidth 1.5 linecolor rgb "#777777", \
     case."/0.4/tank.csv" using 2:3 skip 1 with lines linewidth 2.5 linecolor rgb "black", \
     "<echo 0,0,0.31" using 2:3 with points pointtype 1 pointsize 1.5 linewidth 2 linecolor rgb "black"
unset multiplot
