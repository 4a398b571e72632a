// SPDX-License-Identifier: GPL-3.0-or-later
#include "Liquid.hpp"

#include "ListReader.hpp"
#include "base/numberText.hpp"

#include <algorithm>

namespace slosh
{

namespace
{

/// A box of setFieldsDict in our axes, with the volume fraction that it sets, if any.
struct Region
{
    std::string place;
    std::optional<double> fraction;
    BoundingBox box;
};

class SetFields
{
public:
    SetFields(const Dictionary& dict, const Turn& turn, std::vector<std::string>& warnings)
        : dict_(dict), turn_(turn), warnings_(warnings)
    {
    }

    /// Also of what is in no region.
    std::vector<Region> regions()
    {
        const std::string defaults = dict_.has("defaultValues") ? "defaultValues" : "defaultFieldValues";
        if (dict_.has(defaults) && fractionIn(dict_, defaults).value_or(0) != 0)
        {
            throw errorIn(dict_.placeOf(defaults), "the volume fraction outside the regions is not 0; expected 0");
        }
        std::vector<Region> regions;
        if (dict_.has("zones"))
        {
            const Dictionary zones = dict_.dict("zones");
            for (const auto& name : zones.keys())
            {
                if (!zones.isDict(name))
                {
                    continue; // a macro's value
                }
                const std::string place = zones.placeOf(name);
                const Dictionary zone = zones.dict(name);
                if (const std::string type = zone.word("type"); type != "box")
                {
                    throw errorIn(place, "the zone '" + name + "' is of type " + type + "; expected box");
                }
                regions.push_back({place, fractionIn(zone, "values"), boxIn(zone)});
            }
            return regions;
        }
        ListReader list(dict_, "regions");
        list.expect('(');
        while (!list.nextIs(')'))
        {
            const std::string place = list.place(), kind = list.word();
            if (kind != "boxToCell")
            {
                throw errorIn(place, "the region is " + kind + "; expected boxToCell");
            }
            const Dictionary region = list.dictionary(kind);
            regions.push_back({place, fractionIn(region, "fieldValues"), boxIn(region)});
        }
        return regions;
    }

    const std::string& field() const { return field_; } ///< of the volume fraction

private:
    /// The volume fraction among the values of an entry, { alpha.water 1; } or the list (volScalarFieldValue
    /// alpha.water 1); a warning for each other field.
    std::optional<double> fractionIn(const Dictionary& dict, const std::string& key)
    {
        std::optional<double> fraction;
        if (dict.isDict(key))
        {
            const Dictionary values = dict.dict(key);
            for (const auto& name : values.keys())
            {
                if (isFraction(name, values.placeOf(name)))
                {
                    fraction = values.scalar(name, unit::none);
                }
            }
            return fraction;
        }
        ListReader list(dict, key);
        list.expect('(');
        while (!list.nextIs(')'))
        {
            const std::string place = list.place();
            list.word(); // its type
            if (isFraction(list.word(), place))
            {
                fraction = list.number();
            }
            else
            {
                list.skip();
            }
        }
        return fraction;
    }

    bool isFraction(const std::string& name, const std::string& place)
    {
        if (!name.starts_with("alpha.") && name != "alpha1")
        {
            warnings_.push_back(place + ": " + name + " is not used; the liquid starts at rest, hydrostatic");
            return false;
        }
        if (!field_.empty() && name != field_)
        {
            throw errorIn(place, name + " is set beside " + field_ + "; expected one volume fraction");
        }
        field_ = name;
        return true;
    }

    BoundingBox boxIn(const Dictionary& region) const
    {
        ListReader corners(region, "box");
        const Vec from = corners.vector(), to = corners.vector();
        return turn_(BoundingBox(from.cwiseMin(to), from.cwiseMax(to)));
    }

    Dictionary dict_;
    Turn turn_;
    std::vector<std::string>& warnings_;
    std::string field_;
};

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

Liquid
Liquid::read(const Dictionary& dict, const Turn& turn, const ExtrudedTank& tank, std::vector<std::string>& warnings)
{
    const BoundingBox bounds = tank.bounds();
    const double slack = 1e-9 * bounds.sizes().maxCoeff();
    Liquid liquid;
    SetFields setFields(dict, turn, warnings);
    const std::vector<Region> regions = setFields.regions();
    liquid.field = setFields.field();
    if (liquid.field.empty())
    {
        throw errorIn(
            dict.name(),
            "no volume fraction is set; expected alpha.<phase>, or alpha1 (foam-extend, OpenFOAM before 2.3)"
        );
    }
    for (const auto& [place, fraction, whole] : regions)
    {
        if (!fraction)
        {
            continue;
        }
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
            throw errorIn(
                place, *fraction == 0
                           ? "the box removes liquid of another box; expected boxes of liquid without overlap"
                           : "the volume fraction of the box is " + numberText(*fraction) + "; expected 1"
            );
        }
        if (reachesAllWalls(whole, bounds, slack) && liquid.regions.empty())
        {
            liquid.level = std::max(liquid.level.value_or(box.max().z()), box.max().z());
            continue;
        }
        if (meetsLiquid)
        {
            throw errorIn(place, "the box overlaps another; expected boxes without overlap");
        }
        if (!isWholeIn(box, tank))
        {
            throw errorIn(
                place,
                "the box crosses a slanted wall; expected a box inside the tank, or one that fills it up to a level"
            );
        }
        liquid.regions.push_back(box);
    }
    if (liquid.level && !liquid.regions.empty())
    {
        throw errorIn(
            dict.name(), "boxes are above a box that fills the tank up to a level; expected one or the other"
        );
    }
    if (!liquid.level && liquid.regions.empty())
    {
        throw errorIn(dict.name(), "the regions set no liquid in the tank; expected a box that overlaps it");
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
