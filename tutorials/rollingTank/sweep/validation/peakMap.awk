# The mean peaks of all cases, from their comparisons.tsv: both walls together, with the standard error of the mean.
# From the sweep's directory: awk -f validation/peakMap.awk runs/*/postProcessing/compareSamples/comparisons.tsv
BEGIN {
    FS = "\t"
    print "# angle [deg]  omega [rad/s]  D/dx  mean peak [Pa]  +-  left  right  linear theory"
}

FNR == 1 {
    split(FILENAME, part, "/")
    name = part[2]
    match(name, /^[0-9]+/)
    angle = substr(name, 1, RLENGTH)
    omega = name
    sub(/^[0-9]+deg/, "", omega)
    sub(/rad.*/, "", omega)
    resolution = name
    sub(/.*_/, "", resolution)
    next
}

{
    split($2, figure, " ")     # "4367.6 +- 450 Pa"
    split($3, reference, " ")
}

/left wall/ { left = figure[1]; leftError = figure[3] }
/right wall/ { right = figure[1]; rightError = figure[3] }
/linear theory/ {
    printf "%7d %13d %11d %13.0f %7.0f %7.0f %6.0f %10.0f\n", angle, omega, resolution, (left + right)/2,
        sqrt(leftError^2 + rightError^2)/2, left, right, reference[1]
}
