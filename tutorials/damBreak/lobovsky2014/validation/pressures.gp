# SPDX-License-Identifier: GPL-3.0-or-later
# The front on its way, and the four sensors on the wall it meets, against Lobovsky et al. 2014.
# From the tutorial's directory: gnuplot -e "runs = 'runs/quick runs/coarse runs/softer'" validation/pressures.gp
reset
set terminal pngcairo size 1500,1500 font "DejaVu Sans,14" linewidth 1.4
set output "validation/pressures.png"

folder = system("echo $SLOSH_MEASURED") . "/"
isThere(name) = system("test -f '" . folder . name . "' && echo 1 || echo 0") + 0
record(name) = "< tr ',' ' ' < '" . folder . name . "' | grep '^[0-9]'"
array file[4] = ["s1_z3mm", "s2_z15mm", "s3_z30mm", "s4_z80mm"]
array height[4] = [3, 15, 30, 80]
array colour[5] = ["#0b5fa5", "#d98200", "#4a9a3f", "#8b1a8b", "#c0392b"]
name(run) = run eq "runs/coarse" ? "SloshSPH, H/dx = 25" : run eq "runs/softer" ? "SloshSPH, half the speed of sound" : \
    run eq "runs/friction" ? "SloshSPH, friction" : run eq "runs/paper" ? "SloshSPH, cao2014" : run eq "runs/full" ? "SloshSPH, H/dx = 80" : "SloshSPH, H/dx = 50"
H = 0.3
second = sqrt(H/9.81)
clock = 0.0225      # the pressures' zero after the front's, [s]; comparisonsDict

set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set style fill solid 0.3 noborder
set key top left samplen 2
set multiplot layout 5,1 title "Dam break, column 0.6 m x 0.3 m, wall 1.01 m downstream" \
    margins 0.06,0.98,0.04,0.95 spacing 0.05,0.035
set xrange [0:2.8]
set yrange [0:3.6]
set ylabel "front (x - x_0)/H"
set xlabel "t sqrt(g/H)" offset 0,0.8
etsin = "dambreak_front_ETSIN_H0.3.csv"
martin = "dambreak_front_MartinMoyce1952_H0.057.csv"
plot for [i = 1:words(runs)] "< tr -d '()' < " . word(runs, i) . "/postProcessing/front/0/extent.dat" \
        using ($1/second):(($5 - 0.6)/H) with lines linecolor rgb colour[i] title name(word(runs, i)), \
    for [m = 1:isThere(etsin)] record(etsin) using 1:2 every 3 with points pointtype 6 linecolor rgb "black" \
        title "Lobovsky et al. 2014, H = 0.3 m", \
    for [m = 1:isThere(martin)] record(martin) using 1:2 with points pointtype 2 linecolor rgb "#888888" \
        title "Martin and Moyce 1952, H = 0.057 m"

set xrange [0.42:1.25]
set yrange [-0.3:3.2]
set ylabel "p/({/Symbol r} g H)"
unset xlabel
set key top right
do for [k = 1:4] {
    if (k == 4) { set xlabel "time [s]" offset 0,0.8 }
    set label 1 sprintf("sensor %d, %d mm above the bottom", k, height[k]) at graph 0.5,0.9 center
    name4 = "lobovsky2014_H300_" . file[k] . ".csv"
    plot for [m = 1:isThere(name4)] record(name4) using ($5 + clock):3:4 with filledcurves linecolor rgb "#999999" \
            title k == 1 ? "2.5 to 97.5 % of 100 runs" : "", \
        for [m = 1:isThere(name4)] record(name4) using ($5 + clock):2 with lines linecolor rgb "black" \
            title k == 1 ? "median" : "", \
        for [i = words(runs):1:-1] word(runs, i) . "/postProcessing/pressure/0/p" using 1:(column(k + 1)/(997*9.81*H)) \
            with lines linecolor rgb colour[i] linewidth (i == 1 ? 1.2 : 0.6) notitle
}
unset multiplot
