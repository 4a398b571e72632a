# SPDX-License-Identifier: GPL-3.0-or-later
# Sensor 3 in the roof: the whole of it, and the first four impacts beside the mean and the standard deviation of 102 runs'
# peaks. From the tutorial's directory: gnuplot -e "run = '.'" validation/impacts.gp
reset
set terminal pngcairo size 1500,1000 font "DejaVu Sans,14" linewidth 1.5
set output "validation/impacts.png"

average = "< awk -f ../lateralWater/validation/average.awk " . run . "/postProcessing/pressure/*/p"
peaks = run . "/postProcessing/peakStatistics/sensor3/peaks.dat"
array mean[4] = [4.300, 5.721, 17.239, 12.231]
array deviation[4] = [0.799, 1.032, 6.881, 4.964]
records = int(system("grep -vc '^#' " . peaks . " || true"))    # none where the roof stays dry
n = records < 4 ? records : 4
array instant[4]
if (n > 0) do for [k = 1:n] {
    stats peaks using 1 every ::k-1::k-1 nooutput
    instant[k] = STATS_mean
}

set xlabel "time [s]" offset 0,0.5
set ylabel "pressure [kPa]" offset 1,0
set yrange [-1:40]
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set key top left samplen 2
set multiplot title "SPHERIC 10, water 355.6 mm deep: sensor 3 in the roof, averaged over 1 ms"
set lmargin at screen 0.06
set rmargin at screen 0.98
set tmargin at screen 0.93
set bmargin at screen 0.55
plot average using 1:($2/1000) with lines linecolor rgb "#0b5fa5" title "SloshSPH", \
    for [k = 1:(n > 0 ? n : -1)] "+" using (instant[k]):(mean[k]):(deviation[k]) every ::0::0 with yerrorbars pointtype 7 \
        linecolor rgb "black" title k == 1 ? "peaks of 102 runs in their order: mean, standard deviation" : ""
set tmargin at screen 0.46
set bmargin at screen 0.08
unset key
if (n > 0) do for [k = 1:n] {
    set lmargin at screen 0.06 + 0.235*(k - 1)
    set rmargin at screen 0.06 + 0.235*(k - 1) + 0.20
    if (k > 1) { unset ylabel }
    set title sprintf("impact %d", k) offset 0,-0.6
    set xrange [instant[k] - 0.05:instant[k] + 0.15]
    set xtics 0.1
    set object 1 rectangle from graph 0, first mean[k] - deviation[k] to graph 1, first mean[k] + deviation[k] \
        fillcolor rgb "#888888" fillstyle solid 0.2 noborder behind
    plot mean[k] with lines dashtype 2 linecolor rgb "#666666", average using 1:($2/1000) with lines linecolor rgb "#0b5fa5"
}
unset multiplot
