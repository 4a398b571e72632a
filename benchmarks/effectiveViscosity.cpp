// SPDX-License-Identifier: GPL-3.0-or-later
// The kinematic viscosity nu that each dissipation acts like in a wave v = A sin(k . r) across k, by kernel and h/dx,
// as Markdown. k along an axis of the lattice shears it, along its diagonal strains it along its axes (shear/strain
// below).
//   lattice  by the dissipation alone, at once, on a lattice: dA/dt = -nu k^2 A
//   run      the same, mean over k U t = 3 to 8 in a doubly periodic box of weakly compressible liquid, when the flow
//            has carried the particles off the lattice, which they start up to 0.05 dx away from
//   decay    by the fall of ln A over this time: with all that the pressures of disordered particles do
// Double precision, terms and kernels of src, pairs and time steps of its own. Unit of length dx, of density rho0, of
// speed U = A(0).
#include "PeriodicBox.hpp"

#include "kernels/Kernel.hpp"
#include "viscosities/ViscosityChoice.hpp"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>

namespace
{

using namespace slosh;

constexpr int longWave = 200;                  // on the lattice, where its length costs nothing: k h < 0.1
constexpr double strainFrom = 3, strainTo = 8; // k U t
constexpr double alpha = 0.03;

/// Monaghan's term without its switch, for pairs that part as for those that close in.
struct AllPairs
{
    LineViscosity<double> Pi;

    template <int dim>
    double operator()(const Pair<dim, double, false>& pair, double approach) const
    {
        return Pi(pair, approach) - Pi(pair, -approach);
    }
};

/// nu of the term alone on a lattice, k = 2 pi/wavelength in each direction that the wave has a part in.
template <int dim, class K, class Term>
double onLattice(const Wave<dim>& wave, int wavelength, double h, const Term& Pi)
{
    const int reach = static_cast<int>(K::supportRatio * h);
    double rate = 0;
    for (int row = 0; row < wavelength; ++row) // all that differ in phase
    {
        Point<dim> own{};
        own[1] = row;
        const auto a = particle<dim>(wave.velocity(own), 0, 1);
        double acceleration = 0;
        for (int i = -reach; i <= reach; ++i)
        {
            for (int j = -reach; j <= reach; ++j)
            {
                for (int k = dim == 3 ? -reach : 0; k <= (dim == 3 ? reach : 0); ++k)
                {
                    const int offsets[] = {i, j, k};
                    Point<dim> other = own, x;
                    for (std::size_t d = 0; d < dim; ++d)
                    {
                        other[d] += offsets[d];
                        x[d] = -offsets[d] / h;
                    }
                    if (i == 0 && j == 0 && k == 0)
                    {
                        continue;
                    }
                    withPair<dim>(
                        a, particle<dim>(wave.velocity(other), 0, 1), x,
                        [&](const Pair<dim, double, false>& pair)
                        { acceleration -= Pi(pair, pair.approach) * K::dfByQ(pair.q2) * dot(x, wave.t); }
                    );
                }
            }
        }
        rate -= 2.0 / wavelength * acceleration * std::sin(wave.phase(own));
    }
    return rate * K::alpha(dim) / std::pow(h, dim + 1) / wave.k2();
}

std::string number(double x, int digits = 2)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, x);
    return text;
}

struct InARun
{
    double term, decay; ///< nu
};

template <class K, class Term>
InARun inARun(const Wave<2>& wave, double h, double c0, const Term& Pi)
{
    PeriodicBox<K, Term> box(wave, h, c0, Pi);
    const double dt = 0.4 * h / c0, unit = 1 / std::sqrt(wave.k2());
    const auto first = static_cast<int>(std::ceil(strainFrom * unit / dt));
    const auto last = static_cast<int>(std::ceil(strainTo * unit / dt));
    double sum = 0, start = 0;
    for (int k = 0; k < last; ++k)
    {
        if (k == first)
        {
            start = box.amplitude();
        }
        box.step(dt);
        if (k >= first)
        {
            sum -= box.viscousRate() / box.amplitude();
        }
    }
    return {sum / (last - first) / wave.k2(), std::log(start / box.amplitude()) / ((last - first) * dt) / wave.k2()};
}

std::string twoFigures(double shear, double strain)
{
    return number(shear, 3) + "/" + number(strain, 3);
}

template <int dim, class K, class Term>
std::string shearAndStrainOnLattice(int wavelength, double h, double unit, const Term& Pi)
{
    return twoFigures(
        onLattice<dim, K>(Wave<dim>::alongAxis(wavelength), wavelength, h, Pi) / unit,
        onLattice<dim, K>(Wave<dim>::alongDiagonal(wavelength), wavelength, h, Pi) / unit
    );
}

/// run | decay
template <class K, class Term>
std::string shearAndStrainInARun(double h, double c0, double unit, const Term& Pi)
{
    const InARun shear = inARun<K>(Wave<2>::alongAxis(n), h, c0, Pi);
    const InARun strain = inARun<K>(Wave<2>::alongDiagonal(n), h, c0, Pi);
    return twoFigures(shear.term / unit, strain.term / unit) + " | " +
           twoFigures(shear.decay / unit, strain.decay / unit);
}

template <class F>
void forKernels(const F& f)
{
    f(CubicSpline{});
    f(WendlandC2{});
    f(QuinticSpline{});
    f(ImprovedGaussian{});
    f(TaperedGaussian{});
}

void print(const std::string& line)
{
    std::cout << line << std::endl; // to be seen while the next runs
}

std::string row(std::string_view kernel, double h)
{
    return "| " + std::string(kernel) + " | " + number(h);
}

} // namespace

int main()
{
    constexpr double c0 = 20, usual = 1.23;
    const auto artificial = ArtificialViscosity{alpha, c0, 1, taitGamma}.inLoop<double>(2, usual);

    print("Artificial viscosity, alpha = 0.03, c0 = 20 U; unit alpha h c0/(2 (d + 2))\n\n"
          "| kernel | h/dx | 2D lattice | 2D run | 2D decay | 3D lattice |\n|---|---|---|---|---|---|");
    forKernels(
        [&](auto kernel)
        {
            using K = decltype(kernel);
            for (const double h : {1.0, usual, 1.5, 2.0})
            {
                const double unit2D = alpha * h * c0 / 8, unit3D = alpha * h * c0 / 10;
                print(
                    row(K::name, h) + " | " + shearAndStrainOnLattice<2, K>(longWave, h, unit2D, artificial) + " | " +
                    shearAndStrainInARun<K>(h, c0, unit2D, artificial) + " | " +
                    shearAndStrainOnLattice<3, K>(longWave, h, unit3D, artificial) + " |"
                );
            }
        }
    );

    print(
        "\nThe same formula for all pairs, and laminar viscosity, unit nu, 2D; decay without any, unit alpha h c0/8\n\n"
        "| kernel | h/dx | all pairs, lattice | laminar, lattice | laminar, run | laminar, decay | none, decay |\n"
        "|---|---|---|---|---|---|---|"
    );
    forKernels(
        [&](auto kernel)
        {
            using K = decltype(kernel);
            const double h = usual, nu = alpha * h * c0 / 8;
            const auto laminar = LaminarViscosity{nu}.inLoop<double>(2, h);
            const auto nothing = ArtificialViscosity{0, c0, 1, taitGamma}.inLoop<double>(2, h);
            const std::string none = shearAndStrainInARun<K>(h, c0, nu, nothing);
            print(
                row(K::name, h) + " | " + shearAndStrainOnLattice<2, K>(longWave, h, nu, AllPairs{artificial}) + " | " +
                shearAndStrainOnLattice<2, K>(longWave, h, nu, laminar) + " | " +
                shearAndStrainInARun<K>(h, c0, nu, laminar) + none.substr(none.rfind(" | ")) + " |"
            );
        }
    );

    print("\nLow-dissipation Riemann term, 2D, a wave of 32 dx; unit h c0/8, which is alpha = 1 over all pairs\n\n"
          "| kernel | h/dx | U/c0 | lattice | run | decay |\n|---|---|---|---|---|---|");
    forKernels(
        [&](auto kernel)
        {
            using K = decltype(kernel);
            for (const double c : {10.0, 20.0, 40.0})
            {
                const auto riemann = LowDissipationRiemann{c}.inLoop<double>(2, usual);
                const double h = usual, unit = h * c / 8;
                print(
                    row(K::name, h) + " | " + number(1 / c, 3) + " | " +
                    shearAndStrainOnLattice<2, K>(n, h, unit, riemann) + " | " +
                    shearAndStrainInARun<K>(h, c, unit, riemann) + " |"
                );
            }
        }
    );
}
