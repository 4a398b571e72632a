// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pointText.hpp"

#include <sstream>

namespace slosh
{

std::string text(const Vec& x)
{
    std::ostringstream out;
    out << "(" << x[0] << " " << x[1] << " " << x[2] << ")";
    return out.str();
}

} // namespace slosh
