# SPDX-License-Identifier: GPL-3.0-or-later
# Rows of results.tsv on the waves without and with baffle: awk -f waves.awk <case without> <case with>
# Of a gauge: its highest elevation (crest) and the height of its waves, highest minus lowest level.
function row(what, figure, reference, error, source) { printf "%s\t%s\t%s\t%s\t%s\n", what, figure, reference, error, source }
function metres(x) { return sprintf("%.4f m", x) }
function read(run,   file, line, part, i, level) {
    file = run "/postProcessing/gauges/0/height.dat"
    while ((getline line < file) > 0) {
        if (line ~ /^#/) continue
        split(line, part, " ")
        for (i = 1; i <= 6; ++i) {
            level = part[2*i] - 0.29972
            if (!((run, i) in highest) || level > highest[run, i]) highest[run, i] = level
            if (!((run, i) in lowest) || level < lowest[run, i]) lowest[run, i] = level
        }
    }
    close(file)
    for (i = 1; i <= 6; ++i) height[run, i] = highest[run, i] - lowest[run, i]
}
# Of two gauges, the larger.
function larger(run, i, k) { return height[run, i] > height[run, k] ? height[run, i] : height[run, k] }
BEGIN {
    name[1] = "without baffle"; name[2] = "with baffle"
    for (k = 1; k <= 2; ++k) {
        run = ARGV[k]
        read(run)
        row(name[k] ": P1, largest elevation; wave height", metres(highest[run, 1]) "; " metres(height[run, 1]), "-", "-", "")
        row(name[k] ": wave height in the corners (+ -), (- +) over that in (+ +), (- -)", \
            sprintf("%.3f", larger(run, 5, 6)/larger(run, 3, 4)), k == 1 ? "0" : "-", "-", \
            k == 1 ? "symmetry, linear theory" : "")
        row(name[k] ": wave height at the wall across the baffle over that at the wall parallel to it (P1)", \
            sprintf("%.3f", height[run, 2]/height[run, 1]), k == 1 ? "1" : "-", "-", k == 1 ? "symmetry" : "")
    }
    paper = "Cao et al. 2014, section 3.3"
    elevations = highest[ARGV[1], 1] - highest[ARGV[2], 1]
    heights = height[ARGV[1], 1] - height[ARGV[2], 1]
    row("largest elevation at P1 without less that with baffle", metres(elevations), "about 0.03 m", metres(elevations - 0.03), \
        paper)
    row("wave height at P1 without less that with baffle", metres(heights), "about 0.03 m", metres(heights - 0.03), paper)
}
