// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/Tank.hpp"
#include "particles/Particles.hpp"
#include "particles/particleFiles.hpp"
#include "physics/Rates.hpp"

#include <array>
#include <vector>

namespace slosh
{

/// A bulk viscosity for sound as long as the liquid is deep, which one between neighbours (of the order of h c0, all
/// that is stable) lets ring: a pressure against the mean rate of compression around the nodes J of a grid of spacing
/// L, many particles wide,
///     p_i = rho0 nu sum_J w_iJ phi_J D_J,   D_J = sum_i w_iJ V_i D_i / V_J,   D_i = (drho_i/dt)/rho_i,
/// w_iJ the weights of linear interpolation, V_J = sum w dV over the tank around J, nu = coefficient L c0, D_i that of
/// the motion alone, without density diffusion. As the pressure goes back by the weights that D came by, its power is
///     -sum_i V_i p_i D_i = -rho0 nu sum_J phi_J V_J D_J^2 <= 0
/// at any state, and it leaves alone what keeps its volume. phi_J rises from 0 to 1 where the liquid's share of V_J and
/// of its neighbours goes from 0.1 to 0.6: surfaces, films and spray do not feel it.
/// A wave of wave number k loses its amplitude at nu k^2/2. docs/decisions/0029.
class AcousticDamper
{
public:
    /// `length`: L, [m]; `nu`: [m^2/s]; `rho0`: [kg/m^3]; `rates`: D_J, where a run goes on, [1/s]; where they are not
    /// of this grid they start from zero.
    AcousticDamper(const Tank& tank, double length, double nu, double rho0, std::vector<double> rates);

    /// L where a case says nothing: a quarter of the depth, at least four spacings, [m].
    static double length(const Tank& tank, double spacing);

    /// D_J of this state; `rates` of it or of the evaluation before it. The same bits at any number of threads.
    void update(const Particles& particles, Frame frame, const RigidState& tank, const Rates& rates);

    /// Adds to p of the liquid, [Pa].
    void addTo(Particles& particles, Frame frame, const RigidState& tank) const;

    /// sum_i V_i p_i D_i, what it takes from the liquid, [W], of a slice of unit thickness in 2D.
    double power(const Particles& particles, Frame frame, const RigidState& tank, const Rates& rates) const;

    const std::vector<double>& rates() const { return rates_; } ///< phi_J D_J, [1/s]

private:
    /// f(node, weight) for each of the 2^dim nodes around a point of the tank.
    template <int dim, class F>
    void forNodesAround(const Vec& X, const F& f) const;
    template <int dim>
    double pressure(const Vec& X) const;
    /// Calls f(std::integral_constant<int, dim>) with the tank's.
    template <class F>
    auto withDimension(const F& f) const;
    /// The lowest share of liquid of a node and its neighbours.
    double lowestShare(std::size_t node) const;

    int dim_;
    double length_, nu_, rho0_;
    // By Tank::directions().
    std::array<int, 3> axis_ = {0, 0, 0};
    std::array<double, 3> low_ = {0, 0, 0};
    std::array<std::size_t, 3> count_ = {1, 1, 1}, stride_ = {1, 1, 1}; ///< of nodes
    std::vector<double> volume_;                                        ///< V_J, [m^dim]
    std::vector<double> liquid_;                                        ///< sum_i w_iJ V_i
    std::vector<double> rates_;
    std::vector<double> partial_; ///< sums of parts of the particles, which are added in order
};

} // namespace slosh
