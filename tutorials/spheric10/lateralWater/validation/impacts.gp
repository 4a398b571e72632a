# SPDX-License-Identifier: GPL-3.0-or-later
# Sensor 1 in the first four impacts: record of one run, mean and standard deviation of 102 runs' peaks, the cases `runs`.
# From the tutorial's directory: gnuplot -e "runs = 'runs/quick runs/paper'" validation/impacts.gp
reset
set terminal pngcairo size 1500,1000 font "DejaVu Sans,14" linewidth 1.5
set output "validation/impacts.png"

average = "< awk -f '" . system("echo $SLOSH_ETC") . "/../tutorials/spheric10/validation/average.awk' "
measured = system("echo $SLOSH_MEASURED") . "/spheric10_lateral_water_p_1kHz.csv"
isMeasured = system("test -f '" . measured . "' && echo 1 || echo 0") + 0
array start[4] = [2.30, 3.98, 5.60, 7.22]
array peak[4] = [3.710, 4.816, 4.691, 4.642]
array deviation[4] = [0.732, 1.501, 1.706, 1.323]
array colour[2] = ["#0b5fa5", "#d98200"]

set yrange [-1:16]
set xlabel "time [s]" offset 0,0.5
set ylabel "pressure [kPa]" offset 1,0
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set style fill solid 0.25 noborder
set key top right samplen 2 spacing 1
set multiplot layout 2,2 title "SPHERIC 10, water 93 mm deep: sensor 1 on the left wall, averaged over 1 ms" \
    margins 0.06,0.98,0.07,0.91 spacing 0.07,0.12
do for [k = 1:4] {
    if (k > 1) { unset key }
    set title sprintf("impact %d", k) offset 0,-0.6
    set xrange [start[k]:start[k] + 0.35]
    set object 1 rectangle from graph 0, first peak[k] - deviation[k] to graph 1, first peak[k] + deviation[k] \
        fillcolor rgb "#888888" fillstyle solid 0.2 noborder behind
    plot peak[k] with lines dashtype 2 linecolor rgb "#666666" title "peaks of 102 runs: mean, standard deviation", \
        for [m = 1:isMeasured] "< tr ',' ' ' < '" . measured . "' | grep '^[0-9]'" using 1:($2/1000) with lines \
            linecolor rgb "black" title "measured, one run", \
        for [i = 1:words(runs)] average . word(runs, i) . "/postProcessing/pressure/*/p" using 1:($2/1000) \
            with lines linecolor rgb colour[i] title i == 1 ? "SloshSPH, recommended, friction" : "SloshSPH, cao2014"
}
unset multiplot
