# What the liquid has gained beyond the work done on it, largest at any time: (E - E(0) - W)/scale, E its kinetic, potential and
# internal energy in the inertial frame, W the work of the tank, scale = max(largest |W|, m g D).
# While the tank only translates, its force is what changes the liquid's momentum, F = m (u' - g), and W = int F . V dt, u and V
# from the centre of mass seen in both frames. With `amplitude`, [deg], and `omega`, [rad/s], or `rate`, [rad/s], it rolls or
# rotates about the origin and W = -int M dtheta, M the moment of the liquid's pressure.
BEGIN {
    n = readRows("energies/0/energies.dat", energy)
    readRows("centreOfMass/0/centreOfMass.dat", centre)
    readRows("forces/0/moment.dat", moment)
    mass = logged("blockParticles", "Mass            : ")
    most = mass*9.81*depth
    gravity = weightless ? 0 : 9.81
    for (i = 2; i <= n; ++i)
    {
        dt = energy[i, 1] - energy[i - 1, 1]
        if (rate || omega)
        {
            angle = rate ? rate*dt : amplitude*atan2(0, -1)/180*(sin(omega*energy[i, 1]) - sin(omega*energy[i - 1, 1]))
            work -= (moment[i, 2] + moment[i - 1, 2])/2*angle
        }
        else for (d = 2; d <= 4; ++d)
        {
            tank = (centre[i, d + 3] - centre[i, d] - centre[i - 1, d + 3] + centre[i - 1, d])/dt
            work += mass*tank*(centre[i, d + 6] - centre[i - 1, d + 6] + (d == 4)*gravity*dt)
        }
        most = max(most, abs(work))
        gain[i] = energy[i, 3] + energy[i, 4] + energy[i, 5] - work
    }
    worst = 0
    for (i = 2; i <= n; ++i) worst = max(worst, gain[i] - energy[1, 3] - energy[1, 4] - energy[1, 5])
    printf "%.3g", worst/most
}
