// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/comparisonKeys.hpp"

namespace slosh
{

Keys comparisonKeys()
{
    using namespace comparison;
    return {description, samples,          column,   scale, offset, filter, timeStart,
            timeEnd,     comparison::unit, quantity, ratio, stated, bound};
}

} // namespace slosh
