// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"
#include "motion/SolverFrame.hpp"
#include "particles/Particles.hpp"
#include "physics/Rates.hpp"
#include "physics/WallContact.hpp"

#include <array>
#include <vector>

namespace slosh
{

/// A bulk viscosity for sound as long as the liquid is deep, which one between neighbours (of the order of h c0, all
/// that is stable) lets ring: a pressure against the mean rate of compression around the nodes J of a grid of spacing
/// L or a little more, many particles wide,
///     p_i = rho0 nu sum_J w_iJ phi_J D_J,   D_J = sum_i w_iJ V_i D_i / V_J,   D_i = (drho_i/dt)/rho_i,
/// w_iJ the weights of linear interpolation, V_J = sum w dV over the tank around J, nu = coefficient L c0, D_i that of
/// the motion alone, without density diffusion. As the pressure goes back by the weights that D came by, its power is
///     -sum_i V_i p_i D_i = -rho0 nu sum_J phi_J V_J D_J^2 <= 0
/// at any state, and it leaves alone what keeps its volume. phi_J rises from 0 to 1 where the liquid's share of V_J and
/// of its neighbours goes from 0.1 to 0.6: surfaces, films and spray do not feel it.
///
/// Walls where phi, interpolated, is above 0.2 are enclosed: no air can come to them, and they hold the liquid as the
/// atmosphere would. Where they let go the liquid would have a surface much thinner than L, with which the damping is
/// not stable.
///
/// A wave of wave number k loses its amplitude at nu k^2/2. docs/decisions/0029.
class AcousticDamper
{
public:
    /// `length`: L, [m]; `nu`: [m^2/s]; `rho0`: [kg/m^3]; `state`: state() of the run that goes on; where it is not of
    /// this grid the liquid is without sound and no wall enclosed.
    AcousticDamper(const Tank& tank, double length, double nu, double rho0, const std::vector<double>& state);

    /// L where a case says nothing: a quarter of the depth, at least four spacings, [m].
    static double length(const Tank& tank, double spacing);

    /// D_J of this state; `rates` of it or of the evaluation before it. The same bits at any number of threads.
    void update(const Particles& particles, const SolverFrame& frame, const Rates& rates);

    /// Says of the wall particles at `wallInTank` which are enclosed.
    void findEnclosed(const std::vector<Vec>& wallInTank, std::vector<WallContact>& contact) const;

    /// p_i of liquid at X of the tank, [Pa].
    double pressure(const Vec& X) const;

    std::vector<double> state() const; ///< phi_J D_J of all nodes, [1/s], then phi_J

private:
    /// f(node, weight) for each of the 2^dim nodes around a point of the tank.
    template <int dim, class F>
    void forNodesAround(const Vec& X, const F& f) const;
    /// sum_J w_J f_J.
    template <int dim>
    double interpolate(const std::vector<double>& f, const Vec& X) const;
    /// Calls f(std::integral_constant<int, dim>) with the tank's.
    template <class F>
    auto withDimension(const F& f) const;
    /// The lowest share of liquid of a node and its neighbours.
    double lowestShare(std::size_t node) const;

    int dim_;
    double nu_, rho0_;
    // By Tank::directions().
    std::array<int, 3> axis_ = {0, 0, 0};
    std::array<double, 3> low_ = {0, 0, 0}, spacing_ = {1, 1, 1};       ///< [m]
    std::array<std::size_t, 3> count_ = {1, 1, 1}, stride_ = {1, 1, 1}; ///< of nodes
    std::vector<double> volume_;                                        ///< V_J, [m^dim]
    std::vector<double> liquid_;                                        ///< sum_i w_iJ V_i
    std::vector<double> phi_, rates_;                                   ///< phi_J, phi_J D_J
    std::vector<double> partial_; ///< sums of parts of the particles, which are added in order
};

} // namespace slosh
