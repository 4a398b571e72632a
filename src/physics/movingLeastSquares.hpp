// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/parallel.hpp"
#include "physics/interact.hpp"

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace slosh
{

/// Density re-initialised by moving least squares of first order, Colagrossi & Landrini 2003:
///   rho_a = m sum_b (beta . x_b) W_ab,  A beta = (1 0 ...),  A = sum_b V_b x_b x_b^T W_ab,  x_b = (1, r_ab/h),
/// over liquid and wall particles b and a itself: exact for a density linear in space. Where the neighbours do not span
/// the space (a free drop of few particles) the order falls to zero, rho_a = sum_b m W_ab / sum_b V_b W_ab; a particle
/// alone keeps its density.
template <int dim, class Kernel, class S>
void movingLeastSquares(const PairRecords<RealOf<S>>& records, const NeighbourList& neighbours, std::ptrdiff_t nFluid,
                        double mass, double smoothingLength, std::vector<double>& rho)
{
    using Matrix = Eigen::Matrix<double, dim + 1, dim + 1>;
    using Column = Eigen::Matrix<double, dim + 1, 1>;
    // Below this ratio of pivots the neighbours stand nearly on a line (in 3D: plane) and beta is noise.
    constexpr double leastConditioning = 1e-3;
    const double factor = mass * Kernel::alpha(dim) / std::pow(smoothingLength, dim);

    parallelBlocks(
        nFluid, particlesABlock, [&](std::ptrdiff_t begin, std::ptrdiff_t end) __attribute__((flatten)) {
            for (std::ptrdiff_t a = begin; a < end; ++a)
            {
                std::array<S, dim + 1> first{};                       // sum W x_b
                std::array<std::array<S, dim + 1>, dim + 1> second{}; // sum s_b W x_b x_b^T, lower half
                interact<dim, S>(records, a, neighbours.row(a),
                                 [&](const Pair<dim, S>& pair)
                                 {
                                     std::array<S, dim + 1> x;
                                     x[0] = S(1);
                                     std::copy(pair.x.begin(), pair.x.end(), x.begin() + 1);
                                     const S W = Kernel::f(pair.q2);
                                     for (std::size_t i = 0; i <= dim; ++i)
                                     {
                                         const S Wx = W * x[i];
                                         first[i] += Wx;
                                         for (std::size_t j = 0; j <= i; ++j)
                                         {
                                             second[i][j] += pair.b.s() * Wx * x[j];
                                         }
                                     }
                                 });
                Column c;
                Matrix A;
                for (int i = 0; i <= dim; ++i)
                {
                    const auto k = static_cast<std::size_t>(i);
                    c[i] = factor * laneSum(first[k]);
                    for (int j = 0; j <= i; ++j)
                    {
                        A(i, j) = A(j, i) = factor * laneSum(second[k][j]);
                    }
                }
                const double W0 = factor * Kernel::f(0.0);
                const std::ptrdiff_t i = a;
                c[0] += W0;
                A(0, 0) += W0 / rho[i];

                const Eigen::LDLT<Matrix> factors(A);
                const Column pivots = factors.vectorD();
                const bool spans = pivots.minCoeff() > leastConditioning * A(0, 0);
                rho[i] = spans ? c.dot(factors.solve(Column::Unit(0))) : c[0] / A(0, 0);
            }
        });
}

} // namespace slosh
