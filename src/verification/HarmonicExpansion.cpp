// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/HarmonicExpansion.hpp"

#include <utility>

namespace slosh
{

HarmonicExpansion::HarmonicExpansion(CosineModes modes, double h, int M)
    : modes_(std::move(modes)), M_(M), vertical_(modes_.waveNumbers().size(), M + 1)
{
    const Eigen::ArrayXd& k = modes_.waveNumbers();
    vertical_.col(0) = 1;
    vertical_.col(1) = k * (k * h).tanh();
    for (int j = 2; j <= M; ++j)
    {
        vertical_.col(j) = vertical_.col(j - 2) * k.square();
    }
}

HarmonicExpansion::Terms HarmonicExpansion::operator()(const Eigen::ArrayXd& eta, const Eigen::ArrayXd& f) const
{
    const Eigen::Index P = eta.size();
    Eigen::ArrayXXd power(P, M_ + 1); // eta^j/j!
    power.col(0) = 1;
    for (int j = 1; j <= M_; ++j)
    {
        power.col(j) = power.col(j - 1) * eta / j;
    }
    Terms terms{Eigen::ArrayXXd::Zero(P, M_), Eigen::ArrayXd::Zero(P)};
    Eigen::ArrayXXd onLevel = Eigen::ArrayXXd::Zero(P, M_); // phi_1 ... phi_M, complete up to that whose turn it is
    onLevel.col(0) = f;
    for (int m = 1; m <= M_; ++m)
    {
        const Eigen::ArrayXd phi = modes_.amplitudes(onLevel.col(m - 1), P);
        terms.phi += phi;
        const int highest = M_ - m + 1;
        const Eigen::ArrayXXd derivatives = modes_.values(vertical_.middleCols(1, highest).colwise() * phi);
        for (int j = 1; j <= highest; ++j)
        {
            terms.W.col(m + j - 2) += power.col(j - 1) * derivatives.col(j - 1);
            if (j < highest)
            {
                onLevel.col(m + j - 1) -= power.col(j) * derivatives.col(j - 1);
            }
        }
    }
    return terms;
}

} // namespace slosh
