// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/FunctionObject.hpp"

#include <algorithm>
#include <sstream>

namespace slosh
{

std::vector<Vec> pointsInTank(const FunctionSetting& setting, const Key& key)
{
    const std::vector<Vec> points = setting.dict.vectors(key);
    const Tank& tank = setting.scene.tank;
    if (points.empty())
    {
        throw setting.dict.errorAt(key, "has no point; expected at least one");
    }
    for (const Vec& X : points)
    {
        Vec inSlice = X;
        if (const int d = tank.emptyDirection(); d >= 0)
        {
            inSlice[d] = std::clamp(X[d], tank.box().min()[d], tank.box().max()[d]);
        }
        // On a wall, to rounding, is inside.
        if (tank.distanceToWall(X) < -1e-9 * tank.box().sizes().maxCoeff() || inSlice != X)
        {
            const Vec low = tank.box().min(), high = tank.box().max();
            std::ostringstream message;
            message << "has (" << X.transpose() << "), which is outside the tank, "
                    << (tank.isBox() ? "(" : "a " + tank.walls().name() + " within (") << low.transpose() << ") to ("
                    << high.transpose() << "), or in a body";
            throw setting.dict.errorAt(key, message.str());
        }
    }
    return points;
}

} // namespace slosh
