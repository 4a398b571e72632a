# SPDX-License-Identifier: GPL-3.0-or-later
# The map of mean peaks against frequency for three angles, with error bars; one panel a spacing that has been run.
# From the sweep's directory: gnuplot validation/peakMap.gp
reset
set terminal pngcairo size 1500,900 font "DejaVu Sans,15" linewidth 1.5
set output "validation/peakMap.png"

resolutions = system("awk '!/^#/ && !seen[$3]++ { printf \"%s \", $3 }' validation/peakMap.txt")
angles = system("awk '!/^#/ && !seen[$1]++ { printf \"%s \", $1 }' validation/peakMap.txt")
set xrange [1.5:6.5]
set yrange [0:*]
set xtics 1
set grid linetype 1 linewidth 0.5 linecolor rgb "#dddddd"
set xlabel "roll frequency [rad/s]"
set ylabel "mean pressure peak per period [kPa]"
set key top right
omega1 = 4.0301
set arrow from omega1, graph 0 to omega1, graph 1 nohead dashtype 3 linecolor rgb "black"
set label "{/Symbol w}_1" at omega1 + 0.06, graph 0.04
colours = "#0b5fa5 #2f8f4e #b5480f"
dashes = "1 2 3 4"
set title "Rolling tank: mean peaks in 10-20 s, 0.06 m above the bottom, both walls; bars: standard error of the mean"
plot for [k = 1:words(resolutions)] for [a in angles] "validation/peakMap.txt" \
    using ($1 == int(a) && $3 == int(word(resolutions, k)) ? $2 + 0.03*(k - 1) : NaN):($4/1000):($5/1000) with errorbars \
    pointtype (k == 1 ? 7 : k == 2 ? 5 : k == 3 ? 9 : 11) pointsize 1.6 linecolor rgb word(colours, int(a)/4) \
    title sprintf("%s deg, D/dx = %s", a, word(resolutions, k)), \
    for [k = 1:words(resolutions)] for [a in angles] \
    sprintf("< awk '$1 == %s && $3 == %s' validation/peakMap.txt", a, word(resolutions, k)) \
    using 2:($4/1000) with lines dashtype k linecolor rgb word(colours, int(a)/4) notitle
