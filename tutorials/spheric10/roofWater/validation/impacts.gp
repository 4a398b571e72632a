# SPDX-License-Identifier: GPL-3.0-or-later
# Sensor 3 in the roof: the whole of it, and the first four impacts: record of one run, mean and standard deviation of 102 runs'
# peaks, the case `run`. From the tutorial's directory: gnuplot -e "run = 'runs/quick'" validation/impacts.gp
reset
set terminal pngcairo size 1500,1000 font "DejaVu Sans,14" linewidth 1.5
set output "validation/impacts.png"

average = "awk -f '" . system("echo $SLOSH_ETC") . "/../tutorials/spheric10/validation/average.awk' "
computed = "< " . average . run . "/postProcessing/pressure/*/p"
record = system("echo $SLOSH_MEASURED") . "/spheric10_roof_water_p_windows.csv"
isMeasured = system("test -f '" . record . "' && echo 1 || echo 0") + 0
measured = "< " . average . "-F , -v n=20 '" . record . "'"
array rise[4] = [1.886, 3.013, 4.253, 5.476]
array mean[4] = [4.300, 5.721, 17.239, 12.231]
array deviation[4] = [0.799, 1.032, 6.881, 4.964]

set xlabel "time [s]" offset 0,0.5
set ylabel "pressure [kPa]" offset 1,0
set yrange [-5:40]
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set key top left samplen 2
set multiplot title "SPHERIC 10, water 355.6 mm deep: sensor 3 in the roof, averaged over 1 ms"
set lmargin at screen 0.06
set rmargin at screen 0.98
set tmargin at screen 0.93
set bmargin at screen 0.55
set xrange [0:6]
plot for [k = 1:4] "+" using (rise[k]):(mean[k]):(deviation[k]) every ::0::0 with yerrorbars pointtype 7 linecolor rgb "#666666" \
        title k == 1 ? "peaks of 102 runs: mean, standard deviation" : "", \
    for [m = 1:isMeasured] measured using 1:($2/1000) with lines linecolor rgb "black" title "measured, one run", \
    computed using 1:($2/1000) with lines linecolor rgb "#0b5fa5" title "SloshSPH"
set tmargin at screen 0.46
set bmargin at screen 0.08
unset key
do for [k = 1:4] {
    set lmargin at screen 0.06 + 0.235*(k - 1)
    set rmargin at screen 0.06 + 0.235*(k - 1) + 0.20
    if (k > 1) { unset ylabel }
    set title sprintf("impact %d", k) offset 0,-0.6
    set xrange [rise[k] - 0.1:rise[k] + 0.15]
    set xtics 0.1
    set object 1 rectangle from graph 0, first mean[k] - deviation[k] to graph 1, first mean[k] + deviation[k] \
        fillcolor rgb "#888888" fillstyle solid 0.2 noborder behind
    plot mean[k] with lines dashtype 2 linecolor rgb "#666666", \
        for [m = 1:isMeasured] measured using 1:($2/1000) with lines linecolor rgb "black", \
        computed using 1:($2/1000) with lines linecolor rgb "#0b5fa5"
}
unset multiplot
