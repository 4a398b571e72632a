// SPDX-License-Identifier: GPL-3.0-or-later
// The kinematic viscosity nu that each dissipation acts like in a wave v = A sin(k . r) across k, by kernel and h/dx,
// as Markdown. k along an axis of the lattice shears it, along its diagonal strains it along its axes (shear/strain
// below).
//   lattice  by the dissipation alone, at once, on a lattice: dA/dt = -nu k^2 A
//   run      the same, mean over k U t = 3 to 8 in a doubly periodic box of weakly compressible liquid, when the flow
//   has
//            carried the particles off the lattice, which they start up to 0.05 dx away from
//   decay    by the fall of ln A over this time: with all that the pressures of disordered particles do
// Double precision, terms and kernels of src, pairs and time steps of its own. Unit of length dx, of density rho0, of
// speed U = A(0).
#include "kernels/Kernel.hpp"
#include "physics/Viscosity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace
{

using namespace slosh;

constexpr int n = 32;                           // particles along an edge of the box
constexpr int longWave = 200;                   // on the lattice, where its length costs nothing: k h < 0.1
constexpr double taitGamma = 7, background = 1; // pressure that no particles pull
constexpr double disorder = 0.05;               // dx, at the start of a run
constexpr double strainFrom = 3, strainTo = 8;  // k U t
constexpr double alpha = 0.03;

template <int dim>
using Point = std::array<double, dim>;

template <int dim>
double dot(const Point<dim>& a, const Point<dim>& b)
{
    double sum = 0;
    for (std::size_t d = 0; d < dim; ++d)
    {
        sum += a[d] * b[d];
    }
    return sum;
}

/// v = sin(k . r) along t.
template <int dim>
struct Wave
{
    Point<dim> k{}, t{};

    double k2() const { return dot<dim>(k, k); }
    double phase(const Point<dim>& r) const { return dot<dim>(k, r); }
    Point<dim> velocity(const Point<dim>& r) const
    {
        Point<dim> v = t;
        for (double& component : v)
        {
            component *= std::sin(phase(r));
        }
        return v;
    }

    static Wave alongAxis(int wavelength)
    {
        Wave wave;
        wave.k[1] = 2 * std::numbers::pi / wavelength;
        wave.t[0] = 1;
        return wave;
    }

    static Wave alongDiagonal(int wavelength)
    {
        Wave wave = alongAxis(wavelength);
        wave.k[0] = wave.k[1];
        wave.t[0] = std::sqrt(0.5);
        wave.t[1] = -wave.t[0];
        return wave;
    }
};

/// Monaghan's term without its switch, for pairs that part as for those that close in.
struct AllPairs
{
    ArtificialViscosity::InLoop<double> Pi;

    template <int dim>
    double operator()(const Pair<dim, double>& pair, double approach) const
    {
        return Pi(pair, approach) - Pi(pair, -approach);
    }
};

template <int dim>
Neighbour<dim, double> particle(const Point<dim>& v, double p, double rho)
{
    Neighbour<dim, double> record{};
    record.record[slotP] = p / (rho * rho);
    record.record[slotS] = 1 / rho;
    std::copy(v.begin(), v.end(), record.record.begin() + slotV);
    return record;
}

/// Calls f(pair) of two particles that are r_ab = h x apart.
template <int dim, class F>
void withPair(const Neighbour<dim, double>& a, const Neighbour<dim, double>& b, const Point<dim>& x, const F& f)
{
    const std::uint16_t offset = 0;
    f(Pair<dim, double>{a, b, x, dot<dim>(x, x), 0, &offset});
}

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
                    withPair<dim>(a, particle<dim>(wave.velocity(other), 0, 1), x,
                                  [&](const Pair<dim, double>& pair) {
                                      acceleration -=
                                          Pi(pair, pair.approach()) * K::dfByQ(pair.q2) * dot<dim>(x, wave.t);
                                  });
                }
            }
        }
        rate -= 2.0 / wavelength * acceleration * std::sin(wave.phase(own));
    }
    return rate * K::alpha(dim) / std::pow(h, dim + 1) / wave.k2();
}

/// A doubly periodic box of the liquid of Eq. 1, with the pressure of Tait's equation and a background pressure, so
/// that no pair of particles pulls. Position Verlet, as src/integration/PositionVerlet.hpp.
template <class K, class Term>
class Box
{
public:
    Box(const Wave<2>& wave, double h, double c0, const Term& Pi) : wave_(wave), h_(h), c0_(c0), Pi_(Pi)
    {
        std::mt19937 random(17);
        std::uniform_real_distribution<double> offset(-disorder, disorder);
        for (std::size_t i = 0; i < size; ++i)
        {
            r_[i] = {static_cast<double>(i % n) + offset(random), static_cast<double>(i / n) + offset(random)};
            v_[i] = wave.velocity(r_[i]);
        }
        findPairs();
        evaluateDensityRates();
    }

    /// A of v = A sin(k . r) along t, by least squares.
    double amplitude() const { return amplitudeOf(v_); }
    /// dA/dt by the term alone, half a step ago.
    double viscousRate() const { return amplitudeOf(viscous_); }

    void step(double dt)
    {
        drift(dt / 2);
        evaluateAccelerations();
        for (std::size_t i = 0; i < size; ++i)
        {
            for (std::size_t d = 0; d < 2; ++d)
            {
                v_[i][d] += dt * (inviscid_[i][d] + viscous_[i][d]);
            }
        }
        drift(dt / 2);
        evaluateDensityRates();
        for (std::size_t i = 0; i < size; ++i)
        {
            rho_[i] += dt / 2 * (densityRate_[i] - oldDensityRate_[i]);
        }
        double fastest2 = 0;
        for (const Point<2>& v : v_)
        {
            fastest2 = std::max(fastest2, dot<2>(v, v));
        }
        displacement_ += std::sqrt(fastest2) * dt;
        if (displacement_ > 0.4 * skin)
        {
            findPairs();
        }
    }

private:
    static constexpr std::size_t size = n * n;
    static constexpr double skin = 0.4; // in dx; twice a displacement

    Point<2> difference(std::size_t a, std::size_t b) const
    {
        Point<2> x;
        for (std::size_t d = 0; d < 2; ++d)
        {
            x[d] = r_[a][d] - r_[b][d];
            x[d] -= n * std::round(x[d] / n);
        }
        return x;
    }

    double amplitudeOf(const std::vector<Point<2>>& field) const
    {
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < size; ++i)
        {
            const double s = std::sin(wave_.phase(r_[i]));
            sum += dot<2>(field[i], wave_.t) * s;
            squares += s * s;
        }
        return sum / squares;
    }

    void drift(double dt)
    {
        for (std::size_t i = 0; i < size; ++i)
        {
            for (std::size_t d = 0; d < 2; ++d)
            {
                r_[i][d] += dt * v_[i][d];
            }
            rho_[i] += dt * densityRate_[i];
        }
    }

    void findPairs()
    {
        const double reach = K::supportRatio * h_ + skin;
        pairs_.clear();
        for (std::uint16_t a = 0; a < size; ++a)
        {
            for (std::uint16_t b = 0; b < a; ++b)
            {
                const Point<2> x = difference(a, b);
                if (dot<2>(x, x) < reach * reach)
                {
                    pairs_.emplace_back(a, b);
                }
            }
        }
        displacement_ = 0;
    }

    /// Calls f(a, b, pair, F) of each two particles within the support, grad_a W_ab = F r_ab/h.
    template <class F>
    void forPairs(const F& f)
    {
        const double factor = K::alpha(2) / std::pow(h_, 3);
        for (std::size_t i = 0; i < size; ++i)
        {
            const double p = c0_ * c0_ / taitGamma * (std::pow(rho_[i], taitGamma) - 1) + background;
            record_[i] = particle<2>(v_[i], p, rho_[i]);
        }
        for (const auto& [a, b] : pairs_)
        {
            Point<2> x = difference(a, b);
            x[0] /= h_;
            x[1] /= h_;
            const auto i = a, j = b;
            withPair<2>(record_[a], record_[b], x,
                        [&](const Pair<2, double>& pair)
                        {
                            if (pair.q2 < K::supportRatio * K::supportRatio)
                            {
                                f(i, j, pair, factor * K::dfByQ(pair.q2));
                            }
                        });
        }
    }

    void evaluateAccelerations()
    {
        inviscid_.assign(size, {});
        viscous_.assign(size, {});
        forPairs(
            [&](std::size_t a, std::size_t b, const Pair<2, double>& pair, double F)
            {
                const double pressure = (pair.a.P() + pair.b.P()) * F, viscous = Pi_(pair, pair.approach()) * F;
                for (std::size_t d = 0; d < 2; ++d)
                {
                    inviscid_[a][d] -= pressure * pair.x[d];
                    inviscid_[b][d] += pressure * pair.x[d];
                    viscous_[a][d] -= viscous * pair.x[d];
                    viscous_[b][d] += viscous * pair.x[d];
                }
            });
    }

    void evaluateDensityRates()
    {
        oldDensityRate_ = densityRate_;
        densityRate_.assign(size, 0);
        forPairs(
            [&](std::size_t a, std::size_t b, const Pair<2, double>& pair, double F)
            {
                const double flow = pair.approach() * F;
                densityRate_[a] += rho_[a] / rho_[b] * flow;
                densityRate_[b] += rho_[b] / rho_[a] * flow;
            });
    }

    Wave<2> wave_;
    double h_, c0_;
    Term Pi_;
    std::vector<Point<2>> r_{size}, v_{size}, inviscid_{size}, viscous_{size};
    std::vector<double> rho_ = std::vector<double>(size, 1), densityRate_ = std::vector<double>(size, 0),
                        oldDensityRate_;
    std::vector<Neighbour<2, double>> record_{size};
    std::vector<std::pair<std::uint16_t, std::uint16_t>> pairs_;
    double displacement_ = 0;
};

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
    Box<K, Term> box(wave, h, c0, Pi);
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
    return twoFigures(onLattice<dim, K>(Wave<dim>::alongAxis(wavelength), wavelength, h, Pi) / unit,
                      onLattice<dim, K>(Wave<dim>::alongDiagonal(wavelength), wavelength, h, Pi) / unit);
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
    const auto artificial = ArtificialViscosity{alpha, c0, 1, taitGamma}.inLoop<double>();

    print("Artificial viscosity, alpha = 0.03, c0 = 20 U; unit alpha h c0/(2 (d + 2))\n\n"
          "| kernel | h/dx | 2D lattice | 2D run | 2D decay | 3D lattice |\n|---|---|---|---|---|---|");
    forKernels(
        [&](auto kernel)
        {
            using K = decltype(kernel);
            for (const double h : {1.0, usual, 1.5, 2.0})
            {
                const double unit2D = alpha * h * c0 / 8, unit3D = alpha * h * c0 / 10;
                print(row(K::name, h) + " | " + shearAndStrainOnLattice<2, K>(longWave, h, unit2D, artificial) + " | " +
                      shearAndStrainInARun<K>(h, c0, unit2D, artificial) + " | " +
                      shearAndStrainOnLattice<3, K>(longWave, h, unit3D, artificial) + " |");
            }
        });

    print(
        "\nThe same formula for all pairs, and laminar viscosity, unit nu, 2D; decay without any, unit alpha h c0/8\n\n"
        "| kernel | h/dx | all pairs, lattice | laminar, lattice | laminar, run | laminar, decay | none, decay |\n"
        "|---|---|---|---|---|---|---|");
    forKernels(
        [&](auto kernel)
        {
            using K = decltype(kernel);
            const double h = usual, nu = alpha * h * c0 / 8;
            const auto laminar = LaminarViscosity{nu, h}.inLoop<double>();
            const auto nothing = ArtificialViscosity{0, c0, 1, taitGamma}.inLoop<double>();
            const std::string none = shearAndStrainInARun<K>(h, c0, nu, nothing);
            print(row(K::name, h) + " | " + shearAndStrainOnLattice<2, K>(longWave, h, nu, AllPairs{artificial}) +
                  " | " + shearAndStrainOnLattice<2, K>(longWave, h, nu, laminar) + " | " +
                  shearAndStrainInARun<K>(h, c0, nu, laminar) + none.substr(none.rfind(" | ")) + " |");
        });

    print("\nLow-dissipation Riemann term, 2D, a wave of 32 dx; unit h c0/8, which is alpha = 1 over all pairs\n\n"
          "| kernel | h/dx | U/c0 | lattice | run | decay |\n|---|---|---|---|---|---|");
    forKernels(
        [&](auto kernel)
        {
            using K = decltype(kernel);
            for (const double c : {10.0, 20.0, 40.0})
            {
                const auto riemann = LowDissipationRiemann{c}.inLoop<double>();
                const double h = usual, unit = h * c / 8;
                print(row(K::name, h) + " | " + number(1 / c, 3) + " | " +
                      shearAndStrainOnLattice<2, K>(n, h, unit, riemann) + " | " +
                      shearAndStrainInARun<K>(h, c, unit, riemann) + " |");
            }
        });
}
