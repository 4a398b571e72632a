// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "statistics/TimeSeries.hpp"

#include <string>
#include <utility>
#include <vector>

namespace slosh
{

/// Curves over one axis.
struct Figure
{
    struct Curve
    {
        std::string legend;
        TimeSeries points; ///< t is what stands on the axis
        bool dashed = false;
    };
    struct Mark
    {
        double at = 0; ///< on the axis: a vertical line
        std::string name;
        bool ofMotion = false; ///< in another colour, its name a line higher
    };

    std::string xLabel, yLabel;
    std::vector<Curve> curves;
    std::vector<Mark> marks;
    double xEnd = 0;          ///< where the axis ends; 0: with the curves
    double logarithmFrom = 0; ///< the ordinate is logarithmic from here on; 0: linear

    /// For gnuplot, without terminal and output.
    std::string script() const;
};

/// The terminal of every figure.
inline constexpr const char* figureTerminal = "svg size 640,330 font 'Arial,13' background rgb 'white'";

/// The same series in fewer points: of very many the lowest and the highest of each of `stretches` stretches of time,
/// so that no peak is lost.
TimeSeries thinned(const TimeSeries& series, std::size_t stretches = 800);

/// Text in gnuplot's single quotes.
std::string quoted(const std::string& text);

/// What gnuplot draws of a script, the bytes of a file: "svg size 640,320" or another terminal. Throws CaseError where
/// there is no gnuplot or it fails, with what it says.
std::string draw(const std::string& terminal, const std::string& script);

} // namespace slosh
