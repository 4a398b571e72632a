// SPDX-License-Identifier: GPL-3.0-or-later
// How well the kernels interpolate a function and its derivative from particles: Cao et al. 2014, Figs 2 and 3.
#include "ErrorCurves.hpp"
#include "PointLattice.hpp"
#include "common/Program.hpp"

#include "base/writeFile.hpp"
#include "case/Case.hpp"

#include <cmath>
#include <iostream>
#include <sstream>

using namespace slosh;

namespace
{

namespace kernelAccuracyDict
{

constexpr Key spacing{.name = "spacing", .example = "0.1", .unit = unit::metre, .range = positive, .sentence = "dx"};
constexpr Key domain{
    .name = "domain",
    .example = "2",
    .unit = unit::metre,
    .range = positive,
    .sentence = "edge of the square (cube) filled with points: a whole number of spacings, at most 200; must contain "
                "the kernels' supports around every probe"};
constexpr Key kernels{
    .name = "kernels",
    .leftOut = "all",
    .example = "(cubicSpline wendlandC2 quinticSpline improvedGaussian)",
    .sentence = "names as in constant/kernelProperties"};

constexpr Key direction{
    .name = "direction",
    .otherwise = "(1 1 1)",
    .sentence = "of any length > 0; z is ignored in 2D; the default is the diagonal in 2D and 3D"};
constexpr Key largest{
    .name = "largest", .otherwise = "0.5", .range = notNegative, .sentence = "largest displacement over dx"};
constexpr Key steps{
    .name = "steps", .otherwise = "10", .range = between(1, 10000), .sentence = "number of steps from 0 to largest"};
constexpr Key displacement{
    .name = "displacement", .sentence = "displacement of the probe from the centre of the domain", .entries = [] {
        return Keys{direction, largest, steps};
    }};

constexpr Key lattices{
    .name = "lattices",
    .sentence = "one or more; each writes postProcessing/kernelAccuracy/<name>.dat",
    .entries = PointLattice::keys};

} // namespace kernelAccuracyDict

/// All entries of system/kernelAccuracyDict.
Keys kernelAccuracyDictKeys()
{
    using namespace kernelAccuracyDict;
    return {spacing, domain, kernels, displacement, kernelAccuracyDict::lattices};
}

/// system/kernelAccuracyDict.
struct Test
{
    double dx = 0;     ///< [m]
    double domain = 0; ///< edge of the square or cube that is filled, [m]
    int cells = 0;     ///< domain/dx
    std::vector<std::string> kernels;
    Vec direction = Vec::Zero();
    std::vector<double> dByDx; ///< displacements of the probe from the middle
    std::vector<PointLattice> lattices;

    /// The probes in `dim` dimensions: the middle of the domain + d along the direction.
    std::vector<Vec> probes(int dim) const;
};

Vec inPlane(Vec x, int dim)
{
    if (dim == 2)
    {
        x.z() = 0;
    }
    return x;
}

std::vector<Vec> Test::probes(int dim) const
{
    std::vector<Vec> probes;
    for (const double d : dByDx)
    {
        probes.push_back(inPlane(Vec::Constant(domain / 2), dim) + d * dx * inPlane(direction, dim).normalized());
    }
    return probes;
}

std::vector<std::string> readKernels(const Dictionary& dict)
{
    const auto kernels =
        dict.has(kernelAccuracyDict::kernels) ? dict.words(kernelAccuracyDict::kernels) : Kernel::names();
    const auto valid = Kernel::names();
    if (kernels.empty())
    {
        throw dict.errorAt(kernelAccuracyDict::kernels, "is empty");
    }
    for (const auto& kernel : kernels)
    {
        if (std::find(valid.begin(), valid.end(), kernel) == valid.end())
        {
            throw unknownName("kernel type", kernel, dict.placeOf(kernelAccuracyDict::kernels), valid);
        }
    }
    return kernels;
}

void readDisplacement(const Dictionary& dict, Test& test)
{
    const double largest = dict.scalar(kernelAccuracyDict::largest);
    const long steps = dict.label(kernelAccuracyDict::steps);
    test.direction = dict.vector(kernelAccuracyDict::direction);
    dict.refuseUnknown(kernelAccuracyDict::displacement.entries());
    for (long k = 0; k <= steps; ++k)
    {
        test.dByDx.push_back(largest * static_cast<double>(k) / static_cast<double>(steps));
    }
}

/// Refuses a domain that does not hold whole spacings, more points than a desk computer, or whose border the support
/// of a kernel crosses: what is tested is the kernel, not the border.
void checkDomain(const Dictionary& dict, const Test& test)
{
    if (std::abs(test.cells * test.dx - test.domain) > 1e-6 * test.dx)
    {
        throw dict.errorAt(kernelAccuracyDict::domain, "is not a whole number of spacings");
    }
    for (const auto& lattice : test.lattices)
    {
        double reach = 0;
        for (const auto& name : test.kernels)
        {
            const Kernel kernel(Kernel::choiceNamed(name), lattice.dim, lattice.hOverDx * test.dx);
            reach = std::max(reach, kernel.supportRadius());
        }
        reach += (test.dByDx.back() + lattice.amplitude) * test.dx + (lattice.onNodes ? 0 : test.dx / 2);
        if (test.domain / 2 < reach)
        {
            std::ostringstream message;
            message << "is " << test.domain << " m; the kernels' supports around every probe of " << lattice.name
                    << " need at least " << 2 * reach << " m";
            throw dict.errorAt(kernelAccuracyDict::domain, message.str());
        }
        if (inPlane(test.direction, lattice.dim).norm() == 0)
        {
            throw dict.dict(kernelAccuracyDict::displacement)
                .errorAt(kernelAccuracyDict::direction, "is (0 0 0) in the plane of " + lattice.name);
        }
    }
}

Test readTest(const Dictionary& dict)
{
    Test test;
    test.dx = dict.scalar(kernelAccuracyDict::spacing);
    test.domain = dict.scalar(kernelAccuracyDict::domain);
    test.kernels = readKernels(dict);
    readDisplacement(dict.dictOr(kernelAccuracyDict::displacement), test);
    const Dictionary lattices = dict.dict(kernelAccuracyDict::lattices);
    dict.refuseUnknown(kernelAccuracyDictKeys());
    for (const auto& name : lattices.keys())
    {
        test.lattices.push_back(PointLattice::read(lattices.dict(name), name));
    }
    if (test.lattices.empty())
    {
        throw dict.errorAt(kernelAccuracyDict::lattices, "is empty");
    }
    const double cells = std::round(test.domain / test.dx);
    if (!(cells <= 200))
    {
        throw dict.errorAt(
            kernelAccuracyDict::spacing, "is too small; expected at most 200 spacings along an edge of the domain"
        );
    }
    test.cells = static_cast<int>(cells);
    checkDomain(dict, test);
    return test;
}

std::string description(const PointLattice& lattice, double dx)
{
    std::ostringstream text;
    text << lattice.name << ": f = x^2 + y^2" << (lattice.dim == 3 ? " + z^2" : "") << ", dx = " << dx
         << " m, h = " << lattice.hOverDx << " dx, points " << (lattice.onNodes ? "on nodes" : "at cell centres");
    if (lattice.perturbed())
    {
        text << ", perturbed by " << lattice.amplitude << " dx, " << lattice.samples << " samples, seed "
             << lattice.seed;
    }
    return text.str();
}

ErrorCurves errorCurves(const Test& test, const PointLattice& lattice)
{
    ErrorCurves all{lattice.name, description(lattice, test.dx), lattice.perturbed(), test.dByDx, {}};
    for (const auto& name : test.kernels)
    {
        const Kernel kernel(Kernel::choiceNamed(name), lattice.dim, lattice.hOverDx * test.dx);
        all.curves.push_back({kernel, std::vector<ErrorCurve::Point>(test.dByDx.size())});
    }
    const auto probes = test.probes(lattice.dim);
    const double V = std::pow(test.dx, lattice.dim);
    std::mt19937_64 random(static_cast<std::uint64_t>(lattice.seed));
    for (long sample = 0; sample < lattice.samples; ++sample)
    {
        const auto points = lattice.points(test.cells, test.dx, random);
        for (auto& curve : all.curves)
        {
            const auto loop = errorsOfPairLoop(curve.kernel, points, V, probes);
            for (std::size_t k = 0; k < probes.size(); ++k)
            {
                curve.add(k, errorsInDouble(curve.kernel, points, V, probes[k]), loop[k]);
            }
        }
    }
    return all;
}

void kernelAccuracy(const Case& theCase)
{
    const Test test = readTest(theCase.dictionary("system/kernelAccuracyDict"));
    for (const auto& lattice : test.lattices)
    {
        const ErrorCurves all = errorCurves(test, lattice);
        const std::string file = "postProcessing/kernelAccuracy/" + lattice.name + ".dat";
        writeFile(theCase.root() / file, all.file());
        std::cout << all.table() << "\nWrote " << file << "\n\n" << std::flush;
    }
}

} // namespace

int main(int argc, char** argv)
{
    Program program(
        "kernelAccuracy",
        "Errors of kernel sums for f = x^2 + y^2 (+ z^2) and df/dx, as set in system/kernelAccuracyDict.",
        "kernelAccuracy -case tutorials/kernelAccuracy/cao2014"
    );
    program.addThreads();
    program.addFile("system/kernelAccuracyDict", "read: kernels, lattices and probe positions");
    program.addFile("postProcessing/kernelAccuracy/<lattice>.dat", "written: the errors");
    program.addDictionary(
        {"system/kernelAccuracyDict",
         "Read by kernelAccuracy only: errors of kernel sums for f = x^2 + y^2 (+ z^2) and df/dx.",
         kernelAccuracyDictKeys}
    );
    return program.run(argc, argv, [&] { kernelAccuracy(Case(program.caseFolder())); });
}
