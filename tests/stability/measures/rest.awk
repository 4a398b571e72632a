# Largest kinetic energy relative to the tank from the time `from` on, over m g D.
BEGIN {
    n = readRows("energies/0/energies.dat", row)
    for (i = 1; i <= n; ++i) if (row[i, 1] >= from) most = max(most, row[i, 2])
    g = gravity ? gravity : 9.81
    printf "%.3g", most/(logged("blockParticles", "Mass            : ")*g*depth)
}
