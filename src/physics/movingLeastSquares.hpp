// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/Pair.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>

namespace slosh
{

/// Density re-initialised by moving least squares of first order, Colagrossi & Landrini 2003:
///   rho_a = m sum_b (beta . x_b) W_ab,  A beta = (1 0 ...),  A = sum_b V_b x_b x_b^T W_ab,  x_b = (1, r_ab/h),
/// over liquid and wall particles b and a itself: exact for a density linear in space. Where the neighbours do not span
/// the space (a free drop of few particles) the order falls to zero, rho_a = sum_b m W_ab / sum_b V_b W_ab; a particle
/// alone keeps its density.
template <int dim, class Kernel, class S>
struct MovingLeastSquares
{
    std::array<S, dim + 1> first{};                       ///< sum f x_b
    std::array<std::array<S, dim + 1>, dim + 1> second{}; ///< sum s_b f x_b x_b^T, lower half

    void add(const Pair<dim, S>& pair)
    {
        std::array<S, dim + 1> x;
        x[0] = S(1);
        std::copy(pair.x.begin(), pair.x.end(), x.begin() + 1);
        const S f = Kernel::f(pair.q2);
        for (std::size_t i = 0; i <= dim; ++i)
        {
            const S fx = f * x[i];
            first[i] += fx;
            for (std::size_t j = 0; j <= i; ++j)
            {
                second[i][j] += pair.b.s() * fx * x[j];
            }
        }
    }

    /// rho_a; `factor`: m alpha/h^dim.
    double density(double factor, double rho) const
    {
        using Matrix = Eigen::Matrix<double, dim + 1, dim + 1>;
        using Column = Eigen::Matrix<double, dim + 1, 1>;
        // Below this ratio of pivots the neighbours stand nearly on a line (in 3D: plane) and beta is noise.
        constexpr double leastConditioning = 1e-3;
        Column c;
        Matrix A;
        for (int i = 0; i <= dim; ++i)
        {
            c[i] = factor * laneSum(first[i]);
            for (int j = 0; j <= i; ++j)
            {
                A(i, j) = A(j, i) = factor * laneSum(second[i][j]);
            }
        }
        const double W0 = factor * Kernel::f(0.0);
        c[0] += W0;
        A(0, 0) += W0 / rho;
        const Eigen::LDLT<Matrix> factors(A);
        const Column pivots = factors.vectorD();
        const bool spans = pivots.minCoeff() > leastConditioning * A(0, 0);
        return spans ? c.dot(factors.solve(Column::Unit(0))) : c[0] / A(0, 0);
    }
};

} // namespace slosh
