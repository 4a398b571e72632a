# Wall pressure against rho g h and kinetic energy against m g D in still water.
#   awk -v hydrostatic=<rho g h> -v energy=<m g D> -f stillWater.awk <probes' p> <energies.dat>
/^#/ { next }

FILENAME == ARGV[1] && $1 >= 5 {
    probes = NF - 1
    ++samples
    for (i = 1; i <= probes; ++i) {
        error = ($(i + 1) - hydrostatic) / hydrostatic
        mean[i] += error
        if (error < 0) error = -error
        if (error > largest[i]) largest[i] = error
    }
}

FILENAME == ARGV[2] {
    if ($2 > peak) peak = $2
    half = $1 < 5 ? 1 : 2
    kinetic[half] += $2
    ++n[half]
}

END {
    if (samples == 0 || n[1] == 0 || n[2] == 0) {
        print "no samples before or after 5 s" > "/dev/stderr"
        exit 1
    }
    printf "# Wall pressure, 5 to 10 s, relative to rho g h = %g Pa\n", hydrostatic
    printf "# probe    mean error [%%]   largest [%%]\n"
    for (i = 1; i <= probes; ++i)
        printf "%7d %17.3f %13.3f\n", i - 1, 100 * mean[i] / samples, 100 * largest[i]
    printf "# Kinetic energy relative to m g D = %g J\n", energy
    printf "#   largest   mean, 0 to 5 s   mean, 5 to 10 s\n"
    printf "%11.3g %16.3g %17.3g\n", peak / energy, kinetic[1] / n[1] / energy, kinetic[2] / n[2] / energy
}
