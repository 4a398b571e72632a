# SPDX-License-Identifier: GPL-3.0-or-later
# Pressure histories of the nine cases at the coarsest spacing that has been run.
# From the sweep's directory: gnuplot -e "base = 'runs/recommended'" validation/histories.gp
reset
set terminal pngcairo size 1800,1200 font "DejaVu Sans,13" linewidth 1.2
set output "validation/histories.png"

resolution = system("awk '!/^#/ { print $3; exit }' validation/peakMap.txt")
set xrange [10:20]
set yrange [-1:10]
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
unset key
set multiplot layout 3,3 title "Rolling tank: pressure 0.06 m above the bottom, left wall, D/dx = " . resolution
do for [angle in "4 8 12"] {
    do for [omega in "2 4 6"] {
        set title angle . " deg, " . omega . " rad/s" offset 0,-0.6
        set xlabel angle eq "12" ? "time [s]" : ""
        set ylabel omega eq "2" ? "pressure [kPa]" : ""
        # A case that has not been run leaves its panel empty; of several spacings it is the largest.
        file = system("ls -d " . base . "/postProcessing/sweep/0/runs/spacing=*_angle=" . angle . "_frequency=" . omega . \
            " 2> /dev/null | sort -t = -k 2,2gr | head -n 1") . "/postProcessing/pressure/0/p"
        present = system("test -f " . file . " && echo yes") eq "yes"
        if (present) {
            plot file using 1:($2/1000) with lines linecolor rgb "#0b5fa5"
        } else {
            plot -2 notitle
        }
    }
}
unset multiplot
