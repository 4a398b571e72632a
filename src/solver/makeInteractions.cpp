// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/makeInteractions.hpp"

#include "solver/PairInteractions.hpp"

#include <variant>

namespace slosh
{

// Compiled each in a source of its own: interactions_<kernel>.cpp.
extern template std::unique_ptr<Interactions> makeForKernel<CubicSpline>(const PairGeometry&, const PairTerms&,
                                                                         Precision);
extern template std::unique_ptr<Interactions> makeForKernel<ImprovedGaussian>(const PairGeometry&, const PairTerms&,
                                                                              Precision);
extern template std::unique_ptr<Interactions> makeForKernel<QuinticSpline>(const PairGeometry&, const PairTerms&,
                                                                           Precision);
extern template std::unique_ptr<Interactions> makeForKernel<TaperedGaussian>(const PairGeometry&, const PairTerms&,
                                                                             Precision);
extern template std::unique_ptr<Interactions> makeForKernel<WendlandC2>(const PairGeometry&, const PairTerms&,
                                                                        Precision);

std::unique_ptr<Interactions> makeInteractions(const PairGeometry& geometry, const KernelChoice& kernel,
                                               const PairTerms& terms, Precision precision)
{
    return std::visit([&](auto chosen) { return makeForKernel<decltype(chosen)>(geometry, terms, precision); }, kernel);
}

} // namespace slosh
