// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case/Case.hpp"
#include "statistics/Quantity.hpp"

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace slosh
{

/// What samples are held against: a figure that somebody states, or a series of the same quantity.
struct Reference
{
    std::optional<Estimate> figure;                 ///< stated
    std::optional<std::pair<double, double>> range; ///< stated: from, to
    std::optional<TimeSeries> series;
    std::optional<std::pair<TimeSeries, TimeSeries>> band;       ///< lowest and highest of many runs
    double timeStart = -std::numeric_limits<double>::infinity(); ///< of the part of the series that counts, where it is
    double timeEnd = std::numeric_limits<double>::infinity();    ///< not that of the samples, [s]
    std::string source;
};

/// A record of measurements that is not there: the comparison is left out, visibly.
class MissingRecord : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Reads the sub-dictionary reference of a comparison:
///     { type none; }                            // the figure alone
///     { type stated;  value 4400; uncertainty 250; }  or  { type stated; range (3900 4900); }
///     { type measured; file "lobovsky.csv"; column 1; timeColumn 0; scale 2943; timeScale 0.175; offset 0; timeShift
///     0;
///       lowColumn 2; highColumn 3; }             // comma-separated, in the folder SLOSH_MEASURED
///     { type samples; case "../d0"; samples pressure/p; column 1; scale 1; offset 0; filter 0; timeStart 0; timeEnd 5;
///     }
///                                           // what another case wrote, in its own time where that is given
///     { type linearSloshing; field eta; location (x y z); start atRest; } // eta | p: verification/LinearSloshing.hpp,
///                                                                         // of the case's tank and motion
///     { type nonlinearSloshing; field eta; location (x y z); start atRest; modes 64; order 5; }
///                                               // verification/NonlinearSloshing.hpp, of a 2D tank that sways
///     { type viscousStandingWave; field eta; location (x y z); mode 1; velocity 0.01; nu 0.005; }
///                                               // verification/ViscousStandingWave.hpp, of a 2D tank at rest
///     { type stretchingPatch; field a; A0 1; R 1; }                       // a | b | p, in the case's plane
///     { type stretchingDrop;  field a; A0 1; R 1; }                       // a | c | p
/// and `source`, a text. Exact solutions are evaluated at the times of `samples`. Throws CaseError; MissingRecord where
/// a measured file is not there.
Reference readReference(const Dictionary& dict, const Case& theCase, const TimeSeries& samples);

} // namespace slosh
