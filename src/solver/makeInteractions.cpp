#include "solver/makeInteractions.hpp"

#include "solver/PairInteractions.hpp"

#include <variant>

namespace slosh
{

// Compiled each in a source of its own: interactions_<kernel>.cpp.
extern template std::unique_ptr<Interactions> makeForKernel<CubicSpline>(const PairGeometry&, const ViscosityChoice&,
                                                                         Precision);
extern template std::unique_ptr<Interactions> makeForKernel<ImprovedGaussian>(const PairGeometry&,
                                                                              const ViscosityChoice&, Precision);
extern template std::unique_ptr<Interactions> makeForKernel<QuinticSpline>(const PairGeometry&, const ViscosityChoice&,
                                                                           Precision);
extern template std::unique_ptr<Interactions> makeForKernel<WendlandC2>(const PairGeometry&, const ViscosityChoice&,
                                                                        Precision);

std::unique_ptr<Interactions> makeInteractions(const PairGeometry& geometry, const KernelChoice& kernel,
                                               const ViscosityChoice& viscosity, Precision precision)
{
    return std::visit([&](auto chosen) { return makeForKernel<decltype(chosen)>(geometry, viscosity, precision); },
                      kernel);
}

} // namespace slosh
