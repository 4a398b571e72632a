// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/unrolled.hpp"
#include "physics/Pair.hpp"

#include <Eigen/Dense>

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
    // sum f x_b, and sum s_b f x_b x_b^T, lower half, row by row; both with a itself.
    static constexpr std::size_t first = 0, second = dim + 1, numbers = second + (dim + 1) * (dim + 2) / 2;
    static constexpr std::size_t of(std::size_t i, std::size_t j) { return second + i * (i + 1) / 2 + j; }

    template <class Pair, class SumsA, class SumsB>
    [[gnu::always_inline]] void add(const Pair& pair, const SumsA& a, const SumsB& b) const
    {
        const S f = Kernel::f(pair.q2);
        a.add(first, f);
        b.add(first, f);
        a.addProduct(of(0, 0), pair.b.s, f);
        b.addProduct(of(0, 0), pair.a.s, f);
        unrolled<dim>([&](auto i) __attribute__((always_inline)) {
            // b sees a on the other side.
            const S fx = f * pair.x[i];
            a.add(first + 1 + i, fx);
            b.add(first + 1 + i, -fx);
            a.addProduct(of(i + 1, 0), pair.b.s, fx);
            b.subtractProduct(of(i + 1, 0), pair.a.s, fx);
            unrolled<i + 1>([&](auto j) __attribute__((always_inline)) {
                const S fxx = fx * pair.x[j];
                a.addProduct(of(i + 1, j + 1), pair.b.s, fxx);
                b.addProduct(of(i + 1, j + 1), pair.a.s, fxx);
            });
        });
    }

    /// rho_a; `factor`: m alpha/h^dim.
    static double density(double factor, const std::array<double, numbers>& sums)
    {
        using Matrix = Eigen::Matrix<double, dim + 1, dim + 1>;
        using Column = Eigen::Matrix<double, dim + 1, 1>;
        // Below this ratio of pivots the neighbours stand nearly on a line (in 3D: plane) and beta is noise.
        constexpr double leastConditioning = 1e-3;
        Column c;
        Matrix A;
        for (int i = 0; i <= dim; ++i)
        {
            c[i] = factor * sums[first + i];
            for (int j = 0; j <= i; ++j)
            {
                A(i, j) = A(j, i) = factor * sums[of(i, j)];
            }
        }
        const Eigen::LDLT<Matrix> factors(A);
        const Column pivots = factors.vectorD();
        const bool spans = pivots.minCoeff() > leastConditioning * A(0, 0);
        return spans ? c.dot(factors.solve(Column::Unit(0))) : c[0] / A(0, 0);
    }
};

} // namespace slosh
