// SPDX-License-Identifier: GPL-3.0-or-later
#include "Liquid.hpp"

#include "ListReader.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

/// `volScalarFieldValue alpha.water 1` of a list; other fields are told.
std::optional<double> volumeFractionIn(ListReader list, std::string& phase, std::vector<std::string>& warnings)
{
    std::optional<double> fraction;
    list.expect('(');
    while (!list.nextIs(')'))
    {
        const std::string place = list.place(), type = list.word(), field = list.word();
        if (field.rfind("alpha.", 0) != 0)
        {
            warnings.push_back("'" + field + "'" + place + " is left out: the liquid starts at rest, hydrostatic");
            list.skip();
            continue;
        }
        if (!phase.empty() && field != "alpha." + phase)
        {
            throw CaseError(
                "the liquid cannot be converted: two volume fractions are set, alpha." + phase + " and " + field +
                    place,
                CaseError::Kind::input
            );
        }
        phase = field.substr(6);
        fraction = list.number();
    }
    return fraction;
}

/// Whether all of the tank below the box's top is in it.
bool reachesAllWalls(const BoundingBox& box, const BoundingBox& tank, double slack)
{
    return (box.min().array() <= tank.min().array() + slack).all() &&
           (box.max().head<2>().array() >= tank.max().head<2>().array() - slack).all();
}

bool overlapBy(const BoundingBox& a, const BoundingBox& b, double slack)
{
    const BoundingBox common = a.intersection(b);
    return !common.isEmpty() && (common.sizes().array() > slack).all();
}

bool isWholeIn(const BoundingBox& box, const ExtrudedTank& tank)
{
    for (int corner = 0; corner < 8; ++corner)
    {
        if (!tank.contains(box.corner(static_cast<BoundingBox::CornerType>(corner))))
        {
            return false;
        }
    }
    return true;
}

} // namespace

Liquid Liquid::read(const Dictionary& dict, const ExtrudedTank& tank, std::vector<std::string>& warnings)
{
    const auto fail = [](const std::string& why)
    { return CaseError("the liquid cannot be converted: " + why, CaseError::Kind::input); };
    const BoundingBox bounds = tank.bounds();
    const double slack = 1e-9 * bounds.sizes().maxCoeff();
    Liquid liquid;
    if (dict.has("defaultFieldValues") &&
        volumeFractionIn(ListReader(dict, "defaultFieldValues"), liquid.phase, warnings).value_or(0) != 0)
    {
        throw fail("the volume fraction outside the regions is not 0" + dict.placeOf("defaultFieldValues"));
    }
    ListReader list(dict, "regions");
    list.expect('(');
    while (!list.nextIs(')'))
    {
        const std::string place = list.place(), kind = list.word();
        if (kind != "boxToCell")
        {
            throw fail("the region " + kind + place + " is no boxToCell");
        }
        const Dictionary region = list.dictionary(kind);
        const std::optional<double> fraction =
            volumeFractionIn(ListReader(region, "fieldValues"), liquid.phase, warnings);
        if (!fraction)
        {
            continue;
        }
        ListReader corners(region, "box");
        const Vec from = corners.vector(), to = corners.vector();
        const BoundingBox whole(from.cwiseMin(to), from.cwiseMax(to));
        BoundingBox box = whole.intersection(bounds);
        if (!overlapBy(whole, bounds, slack))
        {
            continue;
        }
        const bool meetsLiquid = (liquid.level && box.min().z() < *liquid.level - slack) ||
                                 std::any_of(
                                     liquid.regions.begin(), liquid.regions.end(),
                                     [&](const BoundingBox& other) { return overlapBy(box, other, slack); }
                                 );
        if (*fraction == 0 && !meetsLiquid)
        {
            continue;
        }
        if (*fraction != 1)
        {
            throw fail(
                "the volume fraction of the box" + place + " is not 1" +
                (*fraction == 0 ? ", and it takes liquid from another" : "")
            );
        }
        if (reachesAllWalls(whole, bounds, slack) && liquid.regions.empty())
        {
            liquid.level = std::max(liquid.level.value_or(box.max().z()), box.max().z());
            continue;
        }
        if (meetsLiquid)
        {
            throw fail("the box" + place + " overlaps another");
        }
        if (!isWholeIn(box, tank))
        {
            throw fail(
                "the box" + place + " reaches across a slanted wall, and does not fill the tank up to one level"
            );
        }
        liquid.regions.push_back(box);
    }
    if (liquid.level && !liquid.regions.empty())
    {
        throw fail("there are a level that fills the tank and boxes above it in " + dict.name());
    }
    if (!liquid.level && liquid.regions.empty())
    {
        throw fail("the regions in " + dict.name() + " set none in the tank");
    }
    return liquid;
}

double Liquid::depth(const ExtrudedTank& tank) const
{
    double top = level.value_or(tank.bounds().min().z());
    for (const auto& box : regions)
    {
        top = std::max(top, box.max().z());
    }
    return top - tank.bounds().min().z();
}

double Liquid::volume(const ExtrudedTank& tank) const
{
    double sum = level ? tank.volumeBelow(*level) : 0;
    for (const auto& box : regions)
    {
        sum += box.volume();
    }
    return sum;
}

} // namespace slosh
