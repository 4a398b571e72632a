# SPDX-License-Identifier: GPL-3.0-or-later
# The samples of a case as a list (mode "list") or as a script for gnuplot with its data. Part of sloshMonitor, which says
# what comes in: files one after another, with marks between them. Needs no more than mawk. No apostrophe may stand here.
# Variables: mode, columns (wanted ones), from (a time), size (<w>x<h>), caseName, terminal, output, faultFile.

# The column of the joined file that this one is: that of the same place, or where it has none of the same name. Names are those
# of the last file; a probe that this no longer has is called p0_before.
function addColumn(word,    k, place, key)
{
    k = ++width
    place = ""
    key = word
    if (file == "p") { place = places[k - 1]; key = place; word = "p" word }
    if (file == "height.dat") { place = places[int((k - 1)/2)]; key = word " " place; word = word int((k - 1)/2) }
    while ((part, key) in taken) key = key "+" # two probes in one place
    taken[part, key] = 1
    if (!(key in columnOf)) columnOf[key] = ++nColumns
    names[columnOf[key]] = word
    at[columnOf[key]] = place
    map[part, k] = columnOf[key]
    lastPart[columnOf[key]] = part
    if (part > withHeader) withHeader = part
}

# Names after "# Time" (of probes: after "# Probe"); "min(X Y Z)" stands for three.
function addColumns(text,    word, prefix, n, k, words)
{
    width = 0
    while (match(text, /[^ \t()]*\([^)]*\)|[^ \t]+/))
    {
        word = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        prefix = ""
        if (match(word, /\(/))
        {
            prefix = substr(word, 1, RSTART - 1)
            word = substr(word, RSTART + 1, length(word) - RSTART - 1)
            isVector = 1
        }
        n = split(word, words, " ")
        for (k = 1; k <= n; k++) addColumn(prefix words[k])
    }
}

# What a column is, for the axis: quantity, unit.
function nameQuantity(name)
{
    unit = "m"; factor = 1
    if (file == "p") { quantity = "pressure"; unit = "Pa" }
    else if (file == "height.dat") quantity = name ~ /^hL/ ? "surface above location" : "surface above bottom"
    else if (file ~ /^(force|moment)\.dat$/ && name ~ /^stops_/)
    {
        quantity = "impulse"
        unit = file == "force.dat" ? "N s" : "N m s"
    }
    else if (file == "force.dat") { quantity = "force"; unit = "N" }
    else if (file == "moment.dat") { quantity = "moment"; unit = "N m" }
    else if (file == "energies.dat") { quantity = "energy"; unit = "J" }
    else if (file == "densityDeviation.dat") { quantity = "|rho/rho0 - 1|"; unit = "%"; factor = 100 }
    else if (file == "centreOfMass.dat" && name ~ /^[uvw]$/) { quantity = "velocity"; unit = "m/s" }
    else if (file == "centreOfMass.dat") quantity = name ~ /^[XYZ]$/ ? "position in the tank" : "position"
    else if (file == "extent.dat") quantity = "position in the tank"
    else if (file == "semiAxes.dat") quantity = "semi-axis"
    else if (file == "particlesOutside.dat") { quantity = "particles"; unit = "" }
    else { quantity = file; sub(/\.dat$/, "", quantity); unit = "" }
}

# Drawn where -columns does not say: those that say most.
function isUsual(name)
{
    if (file == "height.dat") return name ~ /^hB/
    if (file ~ /^(force|moment)\.dat$/) return name ~ /^total_/
    if (file == "energies.dat") return name ~ /^(kinetic|potential|internal|work|residual)$/
    if (file == "centreOfMass.dat") return name ~ /^[XYZ]$/
    if (file == "particlesOutside.dat") return name == "outside"
    return 1
}

# Rows as they come; one takes the place of all that are not before it: a run that went on from an earlier time.
function addRow(line,    n, t)
{
    gsub(/[()]/, " ", line)
    n = split(line, values, " ")
    if (width == 0 || n != width + 1 || values[1] !~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/) return
    t = values[1] + 0
    while (rows > 0 && time[rows] >= t) rows--
    rows++
    time[rows] = t
    row[rows] = line
    partOf[rows] = part
}

function finish(    k, t)
{
    functionFile = folder "/" file
    sub(/\.dat$/, "", functionFile)
    for (k = 1; k <= nColumns; k++) if (lastPart[k] < withHeader) names[k] = names[k] "_before"
    for (k = 1; k <= nColumns; k++) known[names[k]] = 1
    if (mode == "list")
    {
        printf "%s: ", functionFile
        if (rows > 0) printf "t = %s to %s s, %d samples\n   ", time[1], time[rows], rows
        else printf "no sample yet\n   "
        for (k = 1; k <= nColumns; k++) printf " %s%s", names[k], at[k] == "" ? "" : " " at[k] (k < nColumns ? "," : "")
        printf "\n"
        return
    }
    if (rows > 0) draw()
}

# Extremes and first values of each column, then panels: one for each quantity.
function draw(    i, k, n, first, c, varying, chosen, count)
{
    first = rows + 1
    for (i = 1; i <= rows; i++) if (from == "" || time[i] >= from + 0) { first = i; break }
    if (first > rows) return
    for (k = 1; k <= nColumns; k++) { seen[k] = 0; start[k] = "" }
    for (i = 1; i <= rows; i++)
    {
        if (i > 1 && i < first) continue
        n = split(row[i], values, " ")
        for (k = 2; k <= n; k++)
        {
            c = map[partOf[i], k - 1]
            if (values[k] ~ /[nN]/) continue
            if (start[c] == "") start[c] = values[k] + 0
            if (i < first) continue
            if (!seen[c]++) low[c] = high[c] = values[k] + 0
            if (values[k] + 0 < low[c]) low[c] = values[k] + 0
            if (values[k] + 0 > high[c]) high[c] = values[k] + 0
        }
    }
    varying = 0
    for (k = 1; k <= nColumns; k++)
    {
        chosen[k] = seen[k] && (nWanted > 0 ? (names[k] in wanted) : isUsual(names[k]))
        if (chosen[k] && low[k] < high[k]) varying = 1
    }
    for (k = 1; k <= nColumns; k++) # the empty direction of a 2D tank
        if (nWanted == 0 && isVector && varying && low[k] == high[k]) chosen[k] = 0
    for (k = 1; k <= nColumns; k++)
    {
        if (!chosen[k]) continue
        nameQuantity(names[k])
        count = quantity
        for (c = 1; c <= nColumns; c++)
        {
            nameQuantity(names[c])
            inPanel[c] = chosen[c] && quantity == count
            if (inPanel[c]) chosen[c] = 0
        }
        nameQuantity(names[k])
        addPanel(first)
    }
}

function addPanel(first,    k, big, n, shift, lowest, highest, s, curves)
{
    if (panels == 6) { left = left " " functionFile; return }
    panels++
    title[panels] = folder
    s = ""; curves = 0
    for (k = 1; k <= nColumns; k++)
    {
        if (!inPanel[k]) continue
        if (++curves > 8) { more[panels]++; inPanel[k] = 0; continue }
        # Of an energy of position only changes mean something.
        shift[k] = file == "energies.dat" && names[k] == "potential" ? start[k] : 0
        if (s == "" || (low[k] - shift[k])*factor < lowest) lowest = (low[k] - shift[k])*factor
        if (s == "" || (high[k] - shift[k])*factor > highest) highest = (high[k] - shift[k])*factor
        s = "set"
    }
    big = -lowest > highest ? -lowest : highest
    if (unit ~ /^(Pa|N|N m|J)$/ && big >= 2000) { unit = "k" unit; factor = 1e-3; lowest /= 1000; highest /= 1000 }
    if (lowest == highest) { s = lowest == 0 ? 1 : 0.1*(lowest < 0 ? -lowest : lowest) } else s = 0.06*(highest - lowest)
    yLow[panels] = lowest - s
    yHigh[panels] = highest + s
    yLabel[panels] = quantity (unit == "" ? "" : " [" unit "]")
    s = ""
    for (k = 1; k <= nColumns; k++)
    {
        if (!inPanel[k]) continue
        writeCurve(k, first)
        n = ++styled[panels]
        legend[panels, n] = names[k] (shift[k] == 0 ? "" : sprintf(" - %.4g %s", shift[k]*factor, unit))
        place[panels, n] = at[k]
        s = s (s == "" ? "" : ", ") sprintf("$d%d using 1:((column(2) - (%.9g))*%g) with %s ls %d", blocks, shift[k], factor,
            rows - first < 30 ? "linespoints" : "lines", n)
    }
    plot[panels] = s
}

# A curve: all its points, or of very many the lowest and the highest of each of 1500 stretches of time.
function writeCurve(c, first,    i, k, n, stretch, last, v, t, lo, hi, tLo, tHi, thin, any)
{
    printf "$d%d << EOD\n", ++blocks
    thin = rows - first + 1 > 3000
    last = 0; any = 0
    for (i = first; i <= rows; i++)
    {
        if (!((partOf[i], c) in columnIn))
        {
            columnIn[partOf[i], c] = 0
            for (k = 1; (partOf[i], k) in map; k++) if (map[partOf[i], k] == c) columnIn[partOf[i], c] = k
        }
        k = columnIn[partOf[i], c]
        if (k == 0) continue
        split(row[i], values, " ")
        v = values[k + 1]
        if (v ~ /[nN]/) continue
        t = values[1]
        if (!thin) { print t, v; continue }
        stretch = int(1500*(time[i] - time[first])/(time[rows] - time[first]))
        if (any && stretch != last) { writeExtremes(tLo, lo, tHi, hi); any = 0 }
        last = stretch
        if (!any || v + 0 < lo + 0) { lo = v; tLo = t }
        if (!any || v + 0 > hi + 0) { hi = v; tHi = t }
        any = 1
    }
    if (any) writeExtremes(tLo, lo, tHi, hi)
    print "EOD"
    if (tFirst == "" || time[first] < tFirst) tFirst = time[first]
    if (tLast == "" || time[rows] > tLast) tLast = time[rows]
}

function writeExtremes(tLo, lo, tHi, hi)
{
    if (tLo + 0 <= tHi + 0) print tLo, lo
    if (tLo != tHi) print tHi, hi
    if (tLo + 0 > tHi + 0) print tLo, lo
}

# Names in the colours of their curves, from the right end of a line with room for so many pixels; with the places of probes and
# gauges where there is room, else smaller where there is none. A letter takes 10.4 pixels on average.
function writeLegend(p, x, y, room,    k, letters, withPlaces, shrink, entry)
{
    for (k = 1; k <= 8; k++) printf "unset label %d\n", 10 + k
    letters = 0; withPlaces = 0
    for (k = 1; k <= styled[p]; k++)
    {
        letters += length(legend[p, k]) + 4
        withPlaces += length(place[p, k]) + 1
    }
    withPlaces = 10.4*one*(letters + withPlaces) <= room ? 1 : 0
    shrink = !withPlaces && 10.4*one*letters > room ? room/(10.4*one*letters) : 1
    if (shrink < 0.6) shrink = 0.6
    for (k = styled[p]; k >= 1; k--)
    {
        entry = legend[p, k] (withPlaces && place[p, k] != "" ? " " place[p, k] : "")
        printf "set label %d \"\342\226\240 %s\" noenhanced at screen %.4f,%.4f right tc ls %d font \"DejaVu Sans,%.3g\"\n", 10 + k, entry, x, y, k, 15*one*shrink
        x -= 10.4*one*shrink*(length(entry) + 4)/wide
    }
}

# Where panels stand on a page: one column of up to three, else two.
function writePage(    across, down, w, h, p, x, y, bottom, top)
{
    across = panels > 3 ? 2 : 1
    down = int((panels + across - 1)/across)
    w = terminal ~ /png/ ? 1600 : 1200
    h = (down == 1 ? 700 : 85 + 330*down)*w/1600
    if (size != "") { split(size, values, "x"); w = values[1]; h = values[2] }
    wide = w
    one = w/1600 # how long a pixel of a page of the usual width is
    if (one < 0.6) one = 0.6
    printf "set terminal %s size %d,%d font \"DejaVu Sans,%.3g\" linewidth %.3g\n", terminal, w, h, 15*one, 1.6*one
    if (output != "") printf "set output \"%s\"\n", output
    print "set encoding utf8"
    split("#0b5fa5 #c4541a #2e8b57 #8e44ad #555555 #b8901a #1495a8 #c2185b", values, " ")
    for (p = 1; p <= 8; p++) printf "set style line %d lc rgb \"%s\" pt 7 ps %.2g\n", p, values[p], 0.6*one
    print "set grid lt 1 lw 0.5 lc rgb \"#dddddd\"\nset tics nomirror\nset border 3 lc rgb \"#333333\"\nunset key"
    printf "set multiplot\nset label 1 \"%s\" noenhanced at screen %.4f,%.4f left font \"DejaVu Sans:Bold,%.3g\"\n", caseName, 16*one/w, 1 - 22*one/h, 17*one
    printf "set label 2 \"t = %s s\" at screen %.4f,%.4f right font \"DejaVu Sans,%.3g\"\n", tLast, 1 - 16*one/w, 1 - 22*one/h, 17*one
    if (tFirst == tLast) tLast = tFirst + 1
    printf "set xrange [%.9g:%.9g]\n", tFirst, tLast
    for (p = 1; p <= panels; p++)
    {
        x = (p - 1) % across
        y = int((p - 1)/across)
        top = 1 - (45*one + y*(h - 85*one)/down + 42*one)/h
        bottom = 1 - (45*one + (y + 1)*(h - 85*one)/down - 34*one)/h
        printf "set lmargin at screen %.4f\nset rmargin at screen %.4f\n", x/across + 118*one/w, (x + 1)/across - 28*one/w
        printf "set tmargin at screen %.4f\nset bmargin at screen %.4f\n", top, bottom
        printf "set label 3 \"%s\" noenhanced at screen %.4f,%.4f left font \"DejaVu Sans:Bold,%.3g\"\n", title[p] (more[p] ? " (8 of " 8 + more[p] ")" : ""), x/across + 118*one/w, top + 20*one/h, 15*one
        writeLegend(p, (x + 1)/across - 28*one/w, top + 20*one/h, w/across - 146*one - 12.5*one*(length(title[p]) + 1))
        printf "set ylabel \"%s\" noenhanced\nset yrange [%.9g:%.9g]\n", yLabel[p], yLow[p], yHigh[p]
        print (p + across > panels ? "set xlabel \"time [s]\" offset 0,0.4" : "unset xlabel")
        print "plot " plot[p]
        if (p == 1) print "unset label 1\nunset label 2"
    }
    print "unset multiplot"
    if (output != "") print "unset output"
}

BEGIN { n = split(columns, list, /[, ]+/); for (k = 1; k <= n; k++) if (list[k] != "") { wanted[list[k]] = 1; nWanted++ } }

/^\002/ {
    if (folder != "") finish()
    split($0, words, "\t")
    folder = words[2]; file = words[3]
    nColumns = 0; rows = 0; part = 0; isVector = 0; withHeader = 0
    split("", taken)
    split("", columnOf); split("", map); split("", columnIn); split("", at)
    next
}
/^\003/ { part++; width = 0; nPlaces = 0; split("", places); next }
/\001/ { next }
/^# Probe [0-9]+ \(/ { match($0, /\(.*\)/); places[$3] = substr($0, RSTART, RLENGTH); next }
/^# Location : \(/ { match($0, /\(.*\)/); places[nPlaces++] = substr($0, RSTART, RLENGTH); next }
/^# *Probe[ \t]/ && file == "p" { sub(/^# *Probe/, ""); addColumns($0); next }
/^# *Time([ \t]|$)/ { if (file != "p") { sub(/^# *Time/, ""); addColumns($0) } next }
/^#/ { next }
{ addRow($0) }

END {
    for (word in wanted)
        if (!(word in known))
        {
            for (k in known) all = all "\n" k
            printf "Unknown column %s%s\n", word, all > faultFile
            exit 1
        }
    if (mode == "list") exit 0
    if (panels == 0) { print (from == "" ? "no sample yet" : "no sample from t = " from " s on") > faultFile; exit 1 }
    writePage()
    if (left != "") printf "# Omitted: %s\n", substr(left, 2)
}
