# SPDX-License-Identifier: GPL-3.0-or-later
# Wave gauge 0.05 m from the left wall: measured, nonlinear potential flow from the same start, SPH.
# From the case's directory: gnuplot -e "runs='runs/quick'; record='.../faltinsen2000_fig7_h0.6_T1.3.csv'" validation/gauge.gp
reset
set terminal pngcairo size 1500,700 font "DejaVu Sans,15" linewidth 1.5
set output "validation/gauge.png"

isThere(file) = int(system(sprintf("[ -f '%s' ] && echo 1 || echo 0", file)))
samples(alpha) = runs . "/alpha" . alpha . "/postProcessing/gauges/0/height.dat"
nonlinear = runs . "/alpha0.03/postProcessing/compareSamples/nonlinear.dat"

# The record is comma-separated, the samples are not.
measured = isThere(record) ? sprintf("< tr ',' ' ' < '%s' | grep '^[0-9]'", record) : "/dev/null"

set xrange [0:10]
set xlabel "time [s]"
set ylabel "free-surface elevation [m]"
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set key top right horizontal opaque samplen 2
set title "Sway X = 0.032 m cos(2 pi t/1.3 s) from rest, tank 1.73 m, depth 0.6 m: gauge 0.05 m from the left wall"
plot nonlinear using 1:3 with lines linecolor rgb "black" dashtype 2 title "nonlinear potential flow", \
     samples("0.03") using 1:($2 - 0.6) with lines linewidth 1.5 linecolor rgb "#0b5fa5" title "SPH, alpha = 0.03", \
     samples("0.003") using 1:($2 - 0.6) with lines linewidth 1.5 linecolor rgb "#d9820f" title "SPH, alpha = 0.003", \
     measured using 1:2 with points pointtype 6 pointsize 1.1 linecolor rgb "#a50b2c" title "measured"
