// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/makeInteractions.hpp"

#include "physics/interactions.hpp"

#include <variant>

namespace slosh
{

namespace
{

template <class Kernel, class S>
std::unique_ptr<Interactions> inDimension(const PairGeometry& geometry, const PairTerms& terms)
{
    if (geometry.dim == 2)
    {
        return std::make_unique<PairInteractions<2, Kernel, S>>(geometry, terms);
    }
    return std::make_unique<PairInteractions<3, Kernel, S>>(geometry, terms);
}

} // namespace

std::unique_ptr<Interactions>
makeInteractions(const PairGeometry& geometry, const KernelChoice& kernel, const PairTerms& terms, Precision precision)
{
    return std::visit(
        [&]<class K>(K)
        {
            switch (precision)
            {
            case Precision::reference:
                return inDimension<K, double>(geometry, terms);
            case Precision::doublePrecision:
                return inDimension<K, SimdOfRows<double>>(geometry, terms);
            default:
                return inDimension<K, SimdOfRows<float>>(geometry, terms);
            }
        },
        kernel
    );
}

} // namespace slosh
