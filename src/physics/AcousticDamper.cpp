// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/AcousticDamper.hpp"

#include "base/parallel.hpp"
#include "physics/FourtakasDensityDiffusion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>

namespace slosh
{

namespace
{

/// The particles' sums are put together from parts, each with all nodes: as many as do not cost more than the
/// particles.
constexpr std::size_t mostParts = 16;

std::size_t parts(const Particles& particles, std::size_t nodes)
{
    return std::clamp<std::size_t>(static_cast<std::size_t>(particles.nFluid) / (4 * nodes), 1, mostParts);
}

/// The rate of compression by the motion, without density diffusion, [1/s].
double compression(const Particles& particles, std::span<const double> meanDiffusion, const Rates& rates, std::size_t i)
{
    const double mean = meanDiffusion.empty() ? 0 : meanDiffusion[i];
    return (rates.densityRate[i] - rates.diffusion[i] + mean) / particles.rho[i];
}

/// 0 up to 0.1, 1 from 0.6, smooth between.
double inside(double share)
{
    const double x = std::clamp((share - 0.1) / 0.5, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

} // namespace

template <int dim, class F>
void AcousticDamper::forNodesAround(const Vec& X, const F& f) const
{
    std::size_t first = 0;
    std::array<std::array<double, 2>, dim> weight;
    for (std::size_t d = 0; d < dim; ++d)
    {
        // A coordinate that is out of range or NaN (a run that diverges) is clamped.
        const double most = static_cast<double>(count_[d] - 1);
        const double x = std::max(0.0, std::min(most, (X[axis_[d]] - low_[d]) / spacing_[d]));
        const auto cell = std::min(static_cast<int>(x), static_cast<int>(count_[d]) - 2);
        first += static_cast<std::size_t>(cell) * stride_[d];
        weight[d] = {1 - (x - cell), x - cell};
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
        for (std::size_t j = 0; j < 2; ++j)
        {
            const std::size_t node = first + j * stride_[0] + k * stride_[1];
            const double w = weight[0][j] * weight[1][k];
            if constexpr (dim == 2)
            {
                f(node, w);
            }
            else
            {
                f(node, w * weight[2][0]);
                f(node + stride_[2], w * weight[2][1]);
            }
        }
    }
}

template <class F>
auto AcousticDamper::withDimension(const F& f) const
{
    return dim_ == 2 ? f(std::integral_constant<int, 2>()) : f(std::integral_constant<int, 3>());
}

AcousticDamper::AcousticDamper(
    const Tank& tank, double length, double nu, double rho0, const std::vector<double>& state
)
    : dim_(tank.dim()), nu_(nu), rho0_(rho0)
{
    const std::vector<int>& directions = tank.directions();
    const Vec low = tank.box().min(), high = tank.box().max();
    std::size_t nodes = 1;
    for (std::size_t d = 0; d < directions.size(); ++d)
    {
        axis_[d] = directions[d];
        low_[d] = low[directions[d]];
        // Nodes on the box's sides: a sliver of a cell would make a stiff node.
        const double side = (high - low)[directions[d]];
        const double cells = std::max(1.0, std::floor(side / length));
        spacing_[d] = side / cells;
        count_[d] = static_cast<std::size_t>(cells) + 1;
        stride_[d] = nodes;
        nodes *= count_[d];
    }
    volume_.assign(nodes, 0.0);
    liquid_.assign(nodes, 0.0);
    rates_.assign(nodes, 0.0);
    phi_.assign(nodes, 0.0);
    if (state.size() == 2 * nodes)
    {
        std::copy_n(state.begin(), nodes, rates_.begin());
        std::copy_n(state.begin() + static_cast<std::ptrdiff_t>(nodes), nodes, phi_.begin());
    }
    // V_J by midpoints of the cells' parts.
    constexpr std::size_t across = 4;
    double part = 1; // of a cell's volume
    for (std::size_t d = 0; d < directions.size(); ++d)
    {
        part *= spacing_[d] / across;
    }
    std::array<std::size_t, 3> n = {1, 1, 1};
    for (std::size_t d = 0; d < directions.size(); ++d)
    {
        n[d] = (count_[d] - 1) * across;
    }
    for (std::size_t i = 0; i < n[0] * n[1] * n[2]; ++i)
    {
        const std::array<std::size_t, 3> at = {i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
        Vec X = (low + high) / 2;
        for (std::size_t d = 0; d < directions.size(); ++d)
        {
            X[directions[d]] = low[directions[d]] + (static_cast<double>(at[d]) + 0.5) * spacing_[d] / across;
        }
        if (tank.isInside(X))
        {
            withDimension([&](auto dim)
                          { forNodesAround<dim>(X, [&](std::size_t J, double w) { volume_[J] += w * part; }); });
        }
    }
    // A node that hardly reaches into the tank counts as one in a box's corner: nor shall slanted walls make stiff
    // ones.
    const double corner = part * std::pow(across / 2.0, tank.dim());
    for (double& V : volume_)
    {
        V = V > 0 ? std::max(V, corner) : 0;
    }
}

double AcousticDamper::length(const Tank& tank, double spacing)
{
    return std::max(tank.fillDepth() / 4, 4 * spacing);
}

double AcousticDamper::lowestShare(std::size_t node) const
{
    const auto share = [this](std::size_t J) { return volume_[J] > 0 ? liquid_[J] / volume_[J] : 1; };
    double lowest = share(node);
    for (std::size_t d = 0; d < 3; ++d)
    {
        const std::size_t place = node / stride_[d] % count_[d];
        if (place > 0)
        {
            lowest = std::min(lowest, share(node - stride_[d]));
        }
        if (place + 1 < count_[d])
        {
            lowest = std::min(lowest, share(node + stride_[d]));
        }
    }
    return lowest;
}

void AcousticDamper::update(const Particles& particles, const SolverFrame& frame, const Rates& rates)
{
    const std::size_t nodes = volume_.size();
    const std::size_t n = parts(particles, nodes);
    const auto meanDiffusion = particles.values<double>(FourtakasDensityDiffusion::meanField);
    partial_.assign(2 * n * nodes, 0.0);
    const auto addPart = [&]<int dim>(std::integral_constant<int, dim>, std::ptrdiff_t part)
    {
        const std::ptrdiff_t all = particles.nFluid;
        const auto p = static_cast<std::size_t>(part);
        double* liquid = partial_.data() + 2 * p * nodes;
        double* rate = liquid + nodes;
        for (std::size_t i = p * all / n; i < (p + 1) * all / n; ++i)
        {
            const double V = particles.mass / particles.rho[i];
            const double D = compression(particles, meanDiffusion, rates, i);
            forNodesAround<dim>(
                frame.toTank(particles.r[i]),
                [&](std::size_t J, double w)
                {
                    liquid[J] += w * V;
                    rate[J] += w * V * D;
                }
            );
        }
    };
    withDimension(
        [&](auto dim) {
            parallelBlocks(
                static_cast<std::ptrdiff_t>(n), 1, [&](std::ptrdiff_t part, std::ptrdiff_t) { addPart(dim, part); }
            );
        }
    );
    std::fill(liquid_.begin(), liquid_.end(), 0.0);
    std::fill(rates_.begin(), rates_.end(), 0.0);
    for (std::size_t p = 0; p < n; ++p)
    {
        for (std::size_t J = 0; J < nodes; ++J)
        {
            liquid_[J] += partial_[2 * p * nodes + J];
            rates_[J] += partial_[(2 * p + 1) * nodes + J];
        }
    }
    for (std::size_t J = 0; J < nodes; ++J)
    {
        // Where midpoints missed a sliver of the tank there is more liquid than room.
        const double V = std::max(volume_[J], liquid_[J]);
        phi_[J] = inside(lowestShare(J));
        rates_[J] = V > 0 ? phi_[J] * rates_[J] / V : 0;
    }
}

template <int dim>
double AcousticDamper::interpolate(const std::vector<double>& f, const Vec& X) const
{
    double sum = 0;
    forNodesAround<dim>(X, [&](std::size_t J, double w) { sum += w * f[J]; });
    return sum;
}

std::vector<double> AcousticDamper::state() const
{
    std::vector<double> all = rates_;
    all.insert(all.end(), phi_.begin(), phi_.end());
    return all;
}

void AcousticDamper::findEnclosed(const std::vector<Vec>& wallInTank, std::vector<WallContact>& contact) const
{
    withDimension(
        [&](auto dim)
        {
            parallelFor(
                static_cast<std::ptrdiff_t>(contact.size()),
                [&](std::ptrdiff_t w) { contact[w].enclosed = interpolate<dim>(phi_, wallInTank[w]) > 0.2; }
            );
        }
    );
}

double AcousticDamper::pressure(const Vec& X) const
{
    return withDimension([&](auto dim) { return rho0_ * nu_ * interpolate<dim>(rates_, X); });
}

} // namespace slosh
