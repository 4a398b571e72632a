# SPDX-License-Identifier: GPL-3.0-or-later
# Wave gauge 0.04 m from the left wall for the four baffles, and without baffle beside theory.
# From the case's directory: gnuplot -e "runs='runs/quick'" validation/gauges.gp
reset
set terminal pngcairo size 1500,1250 font "DejaVu Sans,15" linewidth 1.5
set output "validation/gauges.png"

gauge(name) = runs . "/" . name . "/postProcessing/gauges/0/height.dat"
compared(name, what) = runs . "/" . name . "/postProcessing/compareSamples/" . what . ".dat"

set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set key top left horizontal opaque samplen 2
set ylabel "free-surface elevation [m]"
set multiplot layout 2,1 title "Surge 2.4 mm at omega1 = 6.864 rad/s, depth D = 0.3 m: gauge 0.04 m from the left wall" \
    margins 0.08,0.98,0.06,0.94 spacing 0.08

set xrange [0:25]
set xlabel "time [s]"
plot gauge("d0") using 1:($2 - 0.3) with lines linecolor rgb "#999999" title "no baffle", \
     gauge("d0.3") using 1:($2 - 0.3) with lines linecolor rgb "#0b5fa5" title "d = 0.3 D", \
     gauge("d0.5") using 1:($2 - 0.3) with lines linecolor rgb "#d9820f" title "d = 0.5 D", \
     gauge("d0.7") using 1:($2 - 0.3) with lines linecolor rgb "#a50b2c" title "d = 0.7 D"

set xrange [0:6.5]
set key top left vertical Left reverse
plot compared("d0", "linear") using 1:3 with lines dashtype 3 linewidth 2 linecolor rgb "black" title "linear theory (to 2 s)", \
     compared("d0", "nonlinear") using 1:3 with lines linewidth 2 linecolor rgb "black" title "nonlinear potential flow", \
     gauge("d0") using 1:($2 - 0.3) with lines linecolor rgb "#999999" title "SPH, alpha = 0.03 (paper)", \
     gauge("d0alpha0.01") using 1:($2 - 0.3) with lines linecolor rgb "#0b5fa5" title "0.01", \
     gauge("d0alpha0.003") using 1:($2 - 0.3) with lines linecolor rgb "#a50b2c" title "0.003"
unset multiplot
