// SPDX-License-Identifier: GPL-3.0-or-later
// Particles at random, and the rows of their lists.
#pragma once

#include "neighbours/NeighbourList.hpp"

#include <map>
#include <random>
#include <set>
#include <vector>

namespace slosh
{

inline Particles randomParticles(int dim, int fluid, int wall, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-1, 1);
    Particles particles;
    particles.resize(fluid, wall);
    for (int i = 0; i < fluid + wall; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        particles.r[k] = Vec(x(random), dim == 3 ? x(random) : 0.25, 0.3 * x(random));
        particles.rho[k] = 1000 + i;
        particles.id[k] = i < fluid ? (7 * i) % fluid : i - fluid;
    }
    return particles;
}

/// The records of a row, those that pad it included.
inline std::vector<std::ptrdiff_t> recordsOf(const NeighbourRows::Row& row, int lanes)
{
    std::vector<std::ptrdiff_t> records;
    for (std::ptrdiff_t k = 0; k < row.groups * neighboursPerGroup(lanes); ++k)
    {
        records.push_back(row.first[k / neighboursPerGroup(lanes)] + std::ptrdiff_t(row.offset[k]));
    }
    return records;
}

inline std::multiset<int> rowOf(const NeighbourList& list, const Particles& particles, std::ptrdiff_t i, int lanes)
{
    std::map<std::ptrdiff_t, int> particleOf;
    for (int k = 0; k < particles.size(); ++k)
    {
        particleOf[recordOf(k)] = k;
    }
    std::multiset<int> row;
    for (const std::ptrdiff_t record : recordsOf(list.row(i), lanes))
    {
        if (const auto found = particleOf.find(record); found != particleOf.end())
        {
            row.insert(found->second);
        }
    }
    return row;
}

} // namespace slosh
