// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Key.hpp"
#include "motion/TankMotion.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slosh
{

class Dictionary;

/// A prescribed motion of the tank: position, velocity and acceleration at any time, consistent to rounding (the
/// derivatives are exact, not differences). Names, coefficients and sign conventions are OpenFOAM's.
class SolidBodyMotion : public TankMotion
{
public:
    virtual RigidState at(double time) const = 0;

    /// The motion as a step from `begin` to `end` feels it: position half-way through, velocities the means of those at
    /// its ends, accelerations their differences over its length. What is integrated with these has the tank's momentum
    /// to rounding, also where the acceleration jumps within the step. At one instant, begin = end, it is at(begin).
    RigidState over(double begin, double end) const;
    TankStep advance(const RigidState&, double begin, double end, const Wrench&) const override
    {
        return {over(begin, end), at(end)};
    }

    /// The interval the motion is defined on, [s]; a table ends. Asking outside throws CaseError.
    virtual double lastTime() const;

    /// One line for the log: "oscillatingRotatingMotion: origin (0 0 0.31), amplitude (8 0 0) deg, omega 4 rad/s".
    virtual std::string description() const = 0;

    /// A tank at rest.
    virtual bool isStationary() const { return false; }

    /// The greatest speed that the corners of `box` (tank coordinates) can have relative to the liquid in it, [m/s], of
    /// the times k end/parts, k = 0 ... parts:
    ///   max(|v(0) - U0|, min(|v - U|, sqrt(|a| L))),   L the longest side of the box,
    /// as liquid follows a tank that changes its velocity slowly. Liquid that rests in the tank at the start, U0 =
    /// v(0), goes with its mean velocity U, so that a tank that travels is as one that stands; else U0 = U = 0.
    double greatestSpeed(const BoundingBox& box, double end, int parts, bool liquidRestsInTank) const;

    /// Reads constant/dynamicMeshDict as OpenFOAM's solvers do. `caseFolder` is where tables are looked up. Throws
    /// CaseError: unknown function (with the nearest name), missing, bad or misspelt coefficients, unreadable table, a
    /// cellZone that moves alone.
    static std::unique_ptr<SolidBodyMotion> read(const Dictionary& dynamicMeshDict, const std::string& caseFolder);

    /// A tank at rest, where a case has no dynamicMeshDict.
    static std::unique_ptr<SolidBodyMotion> stationary();
};

/// The dictionary that holds solidBodyMotionFunction: dynamicMeshDict itself, or mover, solidBodyCoeffs or the like in
/// it, as versions of OpenFOAM have it; nothing where the tank stands still. Throws CaseError for meshes, movers and
/// solvers that are no solid body's.
std::optional<Dictionary> motionDictionary(const Dictionary& dynamicMeshDict);

/// All entries of constant/dynamicMeshDict.
Keys dynamicMeshDictKeys();

} // namespace slosh
