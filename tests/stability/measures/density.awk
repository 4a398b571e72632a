# Largest |rho/rho0 - 1| at any sample.
BEGIN {
    n = readRows("densityDeviation/0/densityDeviation.dat", row)
    for (i = 1; i <= n; ++i) most = max(most, row[i, 2])
    printf "%.3g", most
}
