# SPDX-License-Identifier: GPL-3.0-or-later
# Wave gauge 0.05 m from the left wall: the whole run, and the last cycles beside the measured record.
# From the case's directory:
#     gnuplot -e "runs='runs/quick'; record='.../bouscasse2013_series5.csv'" validation/gauge.gp
reset
set terminal pngcairo size 1500,1000 font "DejaVu Sans,15" linewidth 1.5
set output "validation/gauge.png"

period = 2.99929
samples(case) = runs . "/" . case . "/postProcessing/gauges/0/height.dat"
isThere = int(system(sprintf("[ -f '%s' ] && echo 1 || echo 0", record)))
measured = isThere ? sprintf("< tr ',' ' ' < '%s' | grep '^[0-9]'", record) : "/dev/null"

set xlabel "t/T"
set ylabel "free-surface elevation [m]"
set yrange [-0.03:0.08]
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set key top right horizontal opaque samplen 2
set multiplot layout 2,1 title "Sway 0.07 m sin(2 pi t/T), T = 3 s, tank 1 m, depth 0.03 m: gauge 0.05 m from the left wall" \
    margins 0.08,0.98,0.08,0.93 spacing 0.10
set xrange [0:11]
plot samples("friction") using ($1/period):($2 - 0.03) with lines linecolor rgb "#0b5fa5" title "SPH, recommended, friction", \
     samples("cao2014") using ($1/period):($2 - 0.03) with lines linecolor rgb "#2f8f4e" title "SPH, cao2014"
set xrange [8.5:11]
plot samples("friction") using ($1/period):($2 - 0.03) with lines linewidth 1.5 linecolor rgb "#0b5fa5" title "SPH, recommended, friction", \
     samples("cao2014") using ($1/period):($2 - 0.03) with lines linewidth 1.5 linecolor rgb "#2f8f4e" title "SPH, cao2014", \
     measured using 1:2 with points pointtype 6 pointsize 1.2 linecolor rgb "#a50b2c" title "measured"
unset multiplot
