// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/vorticity.hpp"

#include "sampling/forNeighbours.hpp"

#include <Eigen/LU>

#include <span>

namespace slosh
{

Field vorticity(const Particles& particles, const Scene& scene)
{
    const Kernel& kernel = scene.kernel;
    const int emptyDirection = scene.tank.emptyDirection();
    const std::ptrdiff_t n = particles.nFluid;
    CellGrid grid;
    const std::span<const Vec> liquid = std::span(particles.r).first(n);
    grid.build(liquid, kernel.supportRadius());

    std::vector<Vec> omega(particles.r.size(), Vec::Zero());
    for (std::ptrdiff_t a = 0; a < n; ++a)
    {
        Mat G = Mat::Zero(), M = Mat::Zero();
        forNeighbours(
            grid, liquid, kernel, particles.r[a],
            [&](std::ptrdiff_t b, const Vec& r_ab)
            {
                const Vec r_ba = -r_ab;
                const Vec gradW = kernel.gradFactor(r_ab.norm()) * r_ab;
                const double V_b = particles.mass / particles.rho[b];
                G += V_b * (particles.v[b] - particles.v[a]) * gradW.transpose();
                M += V_b * r_ba * gradW.transpose();
            }
        );
        if (emptyDirection >= 0)
        {
            M(emptyDirection, emptyDirection) = 1;
        }
        if (M.determinant() < 0.01)
        {
            continue;
        }
        const Mat A = G * M.inverse();
        omega[a] = {A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1)};
    }
    return {"vorticity", ParticleRange::all, std::move(omega)};
}

} // namespace slosh
