# What the liquid has gained beyond the work done on it, largest at any time: (E - E(0) - W)/scale, E its kinetic, potential and
# internal energy in the inertial frame, W the work of the tank, scale = max(largest |W|, m g D).
# The tank's work is -int F . V dt while it only translates, V from the centre of mass seen in both frames; with `amplitude`,
# [deg], and `omega`, [rad/s], it rolls about the origin and the work is -int M omega dt.
BEGIN {
    n = readRows("energies/0/energies.dat", energy)
    readRows("centreOfMass/0/centreOfMass.dat", centre)
    readRows("forces/0/force.dat", force)
    readRows("forces/0/moment.dat", moment)
    work = 0
    most = logged("blockParticles", "Mass            : ")*9.81*depth
    for (i = 1; i <= n; ++i)
    {
        if (i > 1)
        {
            if (omega)
            {
                half = amplitude*atan2(0, -1)/180*(sin(omega*energy[i, 1]) - sin(omega*energy[i - 1, 1]))/2
                work -= (moment[i, 2] + moment[i - 1, 2])*half
            }
            else for (d = 2; d <= 4; ++d)
            {
                tank = centre[i, d + 3] - centre[i, d] - centre[i - 1, d + 3] + centre[i - 1, d]
                work -= (force[i, d] + force[i - 1, d])/2*tank
            }
        }
        most = max(most, abs(work))
        gain[i] = energy[i, 3] + energy[i, 4] + energy[i, 5] - work
    }
    worst = 0
    for (i = 2; i <= n; ++i) if (gain[i] - gain[1] > worst) worst = gain[i] - gain[1]
    printf "%.3g", worst/most
}
