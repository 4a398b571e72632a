# SPDX-License-Identifier: GPL-3.0-or-later
# The section of a chamfered tank: its particles at the start, coloured by pressure, and the wall's, and those at the end.
# From the case's directory, after particlesToVTK -format csv -fields '(p)' -frame tank: gnuplot ../validation/section.gp
set terminal pngcairo size 1700,760 font "DejaVu Sans,15"
set output "validation/section.png"
set datafile separator ","

$corners << end
-0.3,0.08
-0.22,0
0.22,0
0.3,0.08
0.3,0.3
0.2,0.4
-0.2,0.4
-0.3,0.3
-0.3,0.08
end

set size ratio -1
set xrange [-0.35:0]
set yrange [-0.05:0.25]
set xlabel "x [m]"
set cbrange [0:2000]
set cblabel "pressure [Pa]"
set palette defined (0 "#c9e3f5", 1 "#0b3c6f")
unset key
set multiplot layout 1,2 margins 0.08,0.89,0.1,0.93 spacing 0.05
unset colorbox
do for [time in "0 10"] {
    set title "t = ".time." s"
    set ylabel (time eq "0" ? "z [m]" : "")
    plot sprintf("postProcessing/particles/%s/wall.csv", time) using 1:3 every ::1 with points pointtype 7 pointsize 0.8 linecolor rgb "#b0a090", \
         sprintf("postProcessing/particles/%s/fluid.csv", time) using 1:3:4 every ::1 with points pointtype 7 pointsize 0.9 palette, \
         $corners using 1:2 with lines linewidth 2 linecolor rgb "black"
    set colorbox
}
unset multiplot
