// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"
#include "particles/Field.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace slosh
{

/// The state of all particles, in double precision, always three components: named fields over [liquid | wall].
///
/// All particles have the same mass m: that is what lattice filling gives, and it keeps a pair record at eight values.
/// A wall (dummy) particle carries the same mass, so that walls and liquid have the same number density.
struct Particles
{
    std::ptrdiff_t nFluid = 0;
    std::ptrdiff_t nWall = 0;

    std::vector<Vec> r;      ///< positions in the solver's frame, [m]
    std::vector<Vec> v;      ///< velocities in the solver's frame, [m/s]
    std::vector<double> rho; ///< density, [kg/m^3]
    std::vector<double> p;   ///< pressure, [Pa]
    std::vector<int> id;     ///< origId: unique within fluid and within wall, kept for life; not an index

    std::vector<Field> more; ///< what else a run's terms remember, or a program has computed

    double mass = 0;    ///< m of one particle; in 2D per metre of thickness: [kg] or [kg/m]
    double spacing = 0; ///< particleSpacing dx = (m/rho0)^(1/dim), [m]

    /// The liquid's bricks, blocks of cells of one global grid (neighbours/sortByBrick.hpp): the first particle of
    /// each, and nFluid. Empty: all are in one.
    std::vector<std::ptrdiff_t> bricks;

    std::ptrdiff_t size() const { return nFluid + nWall; }
    std::ptrdiff_t first(ParticleRange range) const { return range == ParticleRange::wall ? nFluid : 0; }
    std::ptrdiff_t size(ParticleRange range) const
    {
        return range == ParticleRange::liquid ? nFluid : range == ParticleRange::wall ? nWall : size();
    }
    void resize(std::ptrdiff_t fluid, std::ptrdiff_t wall);

    /// Makes `wanted` the fields of `more`: those that are there keep their values, others are zero, the rest go.
    void remember(std::vector<Field> wanted);
    /// The values of a field of `more`, none where it is not there.
    template <class T>
    std::span<T> values(std::string_view name)
    {
        return valuesOf<std::span<T>, T>(more, name);
    }
    template <class T>
    std::span<const T> values(std::string_view name) const
    {
        return valuesOf<std::span<const T>, T>(more, name);
    }

    /// f(name, range, values) for every field, by the name it has in files.
    template <class F>
    void forEachField(const F& f)
    {
        visitFields(*this, f);
    }
    template <class F>
    void forEachField(const F& f) const
    {
        visitFields(*this, f);
    }

    std::size_t bytes() const; ///< of all fields

private:
    template <class Span, class T, class Fields>
    static Span valuesOf(Fields& fields, std::string_view name)
    {
        const auto found =
            std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.name == name; });
        auto* values = found == fields.end() ? nullptr : std::get_if<std::vector<T>>(&found->values);
        return values == nullptr ? Span() : Span(*values);
    }

    template <class Self, class F>
    static void visitFields(Self& self, const F& f)
    {
        f("positions", ParticleRange::all, self.r);
        f("U", ParticleRange::all, self.v);
        f("rho", ParticleRange::all, self.rho);
        f("p", ParticleRange::all, self.p);
        f("origId", ParticleRange::all, self.id);
        for (auto& field : self.more)
        {
            std::visit([&](auto& values) { f(field.name, field.range, values); }, field.values);
        }
    }
};

} // namespace slosh
