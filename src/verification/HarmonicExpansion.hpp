// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/CosineModes.hpp"

namespace slosh
{

/// A harmonic function phi(s, y) between walls s = 0 and L above a bottom y = -h, without flux through these, from its
/// values f on the surface y = eta(s): the Dirichlet-to-Neumann expansion in powers of eta about y = 0,
///
///     phi = sum_m phi_m,  phi_1 = f,  phi_m = -sum_{j=1}^{m-1} eta^j/j! d^j phi_{m-j}/dy^j  on y = 0,
///     W = dphi/dy on the surface = sum_m W_m,  W_m = sum_{j=0}^{m-1} eta^j/j! d^{j+1} phi_{m-j}/dy^{j+1},
///
/// m = 1 ... M; d/dy of cos k_n s is k_n tanh k_n h or k_n in turns. The error of W falls as (k eta)^M for the wave
/// numbers k that f and eta hold; terms of k eta > 1 grow before they fall, and cancel. On P points (CosineModes) the
/// first N modes are exact where f and eta hold no others and 2P > (M + 1) N. Dommermuth & Yue, J. Fluid Mech. 184
/// (1987) 267; West et al., J. Geophys. Res. 92 (1987) 11803.
class HarmonicExpansion
{
public:
    /// h > 0 [m], M >= 1.
    HarmonicExpansion(CosineModes modes, double h, int M);

    const CosineModes& modes() const { return modes_; }

    struct Terms
    {
        Eigen::ArrayXXd W;  ///< W_1 ... W_M in columns, on the grid
        Eigen::ArrayXd phi; ///< amplitudes of phi on y = 0
    };

    /// eta and f on the grid.
    Terms operator()(const Eigen::ArrayXd& eta, const Eigen::ArrayXd& f) const;

private:
    CosineModes modes_;
    int M_;
    Eigen::ArrayXXd vertical_; ///< column j: d^j/dy^j of each mode on y = 0
};

} // namespace slosh
