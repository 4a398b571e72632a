#pragma once

#include "sampling/Snapshot.hpp"

namespace slosh
{

/// Force and moment of the liquid on the tank.
struct Load
{
    Vec force = Vec::Zero();  ///< [N]
    Vec moment = Vec::Zero(); ///< about a point of the tank, [N m]
};

/// What the liquid's pressure does to the walls: the reaction to what the walls do to the liquid in Eq. 1,
///   F = sum_f m sum_w m (p_f/rho_f^2 + p_w/rho_w^2) grad_f W_fw,
/// acting at the liquid particles, in tank axes (tankAxes) or in inertial ones; M about CofR (tank coordinates). In 2D
/// times the slice's thickness. The artificial viscosity between liquid and wall is left out.
Load loadOnTank(const Snapshot& snapshot, const Vec& CofR, bool tankAxes);

} // namespace slosh
