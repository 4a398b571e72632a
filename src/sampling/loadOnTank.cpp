#include "sampling/loadOnTank.hpp"

namespace slosh
{

Load loadOnTank(const Snapshot& snapshot, const Vec& CofR, bool tankAxes)
{
    const Particles& particles = snapshot.particles();
    const Kernel& kernel = snapshot.scene().kernel;
    const Vec origin = snapshot.toSolver(CofR);
    const auto P = [&](std::size_t i) { return particles.p[i] / (particles.rho[i] * particles.rho[i]); };
    Load load;
    for (std::size_t f = 0; f < static_cast<std::size_t>(particles.nFluid); ++f)
    {
        Vec onTank = Vec::Zero();
        snapshot.wallGrid().forEachNear(particles.r[f], kernel.supportRadius(),
                                        [&](int k)
                                        {
                                            const auto w = static_cast<std::size_t>(particles.nFluid + k);
                                            const Vec r = particles.r[f] - particles.r[w];
                                            onTank += (P(f) + P(w)) * kernel.gradFactor(r.norm()) * r;
                                        });
        load.force += onTank;
        load.moment += (particles.r[f] - origin).cross(onTank);
    }
    const double m2 = particles.mass * particles.mass * snapshot.scene().tank.thickness();
    // The solver's axes are the tank's or the inertial ones.
    const Mat& R = snapshot.state().tank.R;
    const bool inTank = snapshot.state().frame == Frame::tank;
    const Mat toWanted = inTank == tankAxes ? Mat(Mat::Identity()) : tankAxes ? Mat(R.transpose()) : R;
    load.force = m2 * (toWanted * load.force);
    load.moment = m2 * (toWanted * load.moment);
    return load;
}

} // namespace slosh
