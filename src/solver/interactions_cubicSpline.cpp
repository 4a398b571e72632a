#include "solver/PairInteractions.hpp"

namespace slosh
{

template std::unique_ptr<Interactions> makeForKernel<CubicSpline>(const PairGeometry&, const ViscosityChoice&,
                                                                  Precision);

} // namespace slosh
