# SPDX-License-Identifier: GPL-3.0-or-later
# Pressure at the two wall probes and the mean of the highest pressure per period that compareSamples found.
# From the case's directory: gnuplot validation/pressure.gp
reset
set terminal pngcairo size 1500,1000 font "DejaVu Sans,15" linewidth 1.5
set output "validation/pressure.png"

samples = "postProcessing/pressure/0/p"
array mean[2]
do for [i = 1:2] {
    # Second column: "4367.6 +- 480 Pa".
    mean[i] = real(system(sprintf("awk -F'\t' 'NR == %d { print $2 + 0 }' postProcessing/compareSamples/comparisons.tsv", i + 1)))/1000
}

set xrange [0:20]
set yrange [-0.5:*]
set xlabel "time [s]"
set ylabel "pressure [kPa]"
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
unset key
set multiplot layout 2,1 title "Rolling tank: 8 deg, 4 rad/s, liquid depth 0.155 m, probes 0.06 m above the bottom" \
    margins 0.07,0.98,0.08,0.90 spacing 0.11
do for [i = 1:2] {
    if (i == 2) { set xlabel "time [s]" } else { unset xlabel }
    set title sprintf("%s wall; dashed: mean peak per period after 10 s, %.2f kPa", \
        i == 1 ? "left" : "right", mean[i]) offset 0,-0.5
    plot samples using 1:(column(i + 1)/1000) with lines linecolor rgb (i == 1 ? "#0b5fa5" : "#b5480f"), \
         mean[i] with lines dashtype 2 linecolor rgb "black"
}
unset multiplot
