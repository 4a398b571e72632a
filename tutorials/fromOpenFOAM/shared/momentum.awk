# SPDX-License-Identifier: GPL-3.0-or-later
# Newton's second law of the liquid as a whole: what the tank gives it in a run, against its weight and the momentum it has gained.
#     awk -v what=<the run> -v mass=<kg> -v g=<m/s^2> -f momentum.awk centreOfMass.dat force.dat
# One row as compareSamples writes them; the forces' integral by trapezoids.
{
    gsub(/[()]/, " ")
}
/^#/ || NF < 4 {
    next
}
FNR == NR {
    if (!started++)
        w0 = $10
    w1 = $10
    next
}
{
    if (samples++)
        impulse -= ($1 - t)*($4 + before)/2
    else
        t0 = $1
    t = $1
    before = $4
}
END {
    T = t - t0
    mean = impulse/T
    wanted = mass*(g + (w1 - w0)/T)
    printf "vertical force on the liquid, mean of the %s\t%.5g N\t%.5g N\t%+.2f %%\tm (g + dw/dt)\n", what, mean, wanted, 100*(mean/wanted - 1)
}
