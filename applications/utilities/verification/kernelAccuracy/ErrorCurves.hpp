// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernelSums.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// Mean and standard deviation (over n - 1) of numbers given one by one, Welford 1962.
class Moments
{
public:
    void add(double x)
    {
        ++n_;
        const double difference = x - mean_;
        mean_ += difference / static_cast<double>(n_);
        squares_ += difference * (x - mean_);
    }
    double mean() const { return mean_; }
    double deviation() const;

private:
    long n_ = 0;
    double mean_ = 0, squares_ = 0;
};

/// The errors of one kernel over the displacement of the probe.
struct ErrorCurve
{
    struct Point
    {
        Moments f, dfdx, unity, neighbours; ///< in double precision
        Moments loopF, loopDfdx;            ///< of the pair loop
        int onEdge = 0;                     ///< most points on the edge of the support
    };

    Kernel kernel;
    std::vector<Point> points;
    double differenceF = 0, differenceDfdx = 0; ///< largest |pair loop - double| of any sample

    void add(std::size_t point, const KernelErrors& reference, const KernelErrors& loop);
};

/// The curves of all kernels on one lattice.
struct ErrorCurves
{
    std::string lattice;       ///< its name
    std::string description;   ///< one line
    bool perturbed = false;    ///< then deviations are written, too
    std::vector<double> dByDx; ///< displacements of the probe
    std::vector<ErrorCurve> curves;

    /// For the log: both sums, their largest difference, the sum of the weights, the neighbours.
    std::string table() const;
    /// For the file: one row a displacement, columns of one kernel after the other, named in the last line of comments.
    std::string file() const;
};

} // namespace slosh
