// SPDX-License-Identifier: GPL-3.0-or-later
#include "Turn.hpp"

#include <array>

namespace slosh
{

std::optional<Turn> Turn::upright(const Vec& g)
{
    if (g.norm() == 0)
    {
        return Turn();
    }
    // The rows: our x, y, z. x stays where it can.
    const auto rows = [](const Vec& x, const Vec& y, const Vec& z)
    {
        Turn turn;
        turn.R << x.transpose(), y.transpose(), z.transpose();
        return turn;
    };
    const Vec x = Vec::UnitX(), y = Vec::UnitY(), z = Vec::UnitZ();
    for (const Turn& turn :
         {rows(x, y, z), rows(x, -z, y), rows(y, z, x), rows(x, -y, -z), rows(x, z, -y), rows(y, -z, -x)})
    {
        const Vec turned = turn(g);
        if (turned.x() == 0 && turned.y() == 0 && turned.z() < 0)
        {
            return turn;
        }
    }
    return std::nullopt;
}

BoundingBox Turn::operator()(const BoundingBox& box) const
{
    BoundingBox turned((*this)(box.min()));
    turned.extend((*this)(box.max()));
    return turned;
}

std::string Turn::description() const
{
    static const std::array<std::string, 3> names{"x", "y", "z"};
    std::string text;
    for (int ours = 0; ours < 3; ++ours)
    {
        for (int theirs = 0; theirs < 3; ++theirs)
        {
            if (R(ours, theirs) != 0)
            {
                text += std::string(ours > 0 ? " " : "") + (R(ours, theirs) < 0 ? "-" : "") + names[theirs];
            }
        }
    }
    return text;
}

} // namespace slosh
