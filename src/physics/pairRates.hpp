#pragma once

#include "base/parallel.hpp"
#include "physics/Rates.hpp"
#include "physics/interact.hpp"

#include <array>
#include <cmath>

namespace slosh
{

/// The sums of Cao et al. 2014, Eq. 1 for every liquid particle a, over liquid and wall particles b of mass m:
///   drho_a/dt = rho_a m sum_b (1/rho_b) (v_a - v_b) . grad_a W_ab
///   dv_a/dt   = -m sum_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) grad_a W_ab     (without the body force)
/// grad_a W_ab = alpha/h^(dim+1) dfByQ(q^2) r_ab/h: the factor in front is applied once per particle.
template <int dim, class Kernel, class S, class Viscosity>
void pairRates(const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, std::ptrdiff_t nFluid,
               double mass, double smoothingLength, const Viscosity& viscosity, Rates& rates)
{
    const auto Pi = viscosity.template inLoop<S>();
    const double factor = mass * Kernel::alpha(dim) / std::pow(smoothingLength, dim + 1);

    parallelBlocks(nFluid, 128,
                   [&](std::ptrdiff_t begin, std::ptrdiff_t end)
                   {
                       for (std::ptrdiff_t a = begin; a < end; ++a)
                       {
                           S divergence(0);
                           std::array<S, dim> gradient{};
                           interact<dim, S>(records, a, neighbours.row(a),
                                            [&](const Pair<dim, S>& pair)
                                            {
                                                const S F = Kernel::dfByQ(pair.q2);
                                                const S approach = pair.approach();
                                                divergence += pair.b.s() * approach * F;
                                                const S pressure = (pair.a.P() + pair.b.P() + Pi(pair, approach)) * F;
                                                for (std::size_t d = 0; d < dim; ++d)
                                                {
                                                    gradient[d] += pressure * pair.x[d];
                                                }
                                            });
                           const auto i = static_cast<std::size_t>(a);
                           const double rho = 1 / static_cast<double>(records.data()[8 * a + slotS]);
                           rates.densityRate[i] = rho * factor * laneSum(divergence);
                           for (int d = 0; d < dim; ++d)
                           {
                               rates.acceleration[i][records.direction(d)] =
                                   -factor * laneSum(gradient[static_cast<std::size_t>(d)]);
                           }
                       }
                   });
}

} // namespace slosh
