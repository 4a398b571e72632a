// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/Kernel.hpp"

#include <cmath>

namespace slosh
{

namespace
{

template <class... Kernels>
std::vector<Kernel::Choice> tableOf(const std::variant<Kernels...>&)
{
    return {{Kernels::name, Kernels::sentence, []() -> KernelChoice { return Kernels{}; }}...};
}

namespace kernelProperties
{

constexpr Key kernel{
    .name = "kernel",
    .leftOut = "by scheme: smallWaves taperedGaussian, else improvedGaussian",
    .example = "improvedGaussian",
    .options = [] { return optionsOf(Kernel::choices()); }};
constexpr Key hOverDx{
    .name = "hOverDx",
    .leftOut = "1.23 in 2D, 1 in 3D; 1.3 in scheme smallWaves with its kernel",
    .example = "1.23",
    .range = between(0.9, 4),
    .sentence = "smoothing length h over particle spacing"};

} // namespace kernelProperties

} // namespace

Keys kernelPropertiesKeys()
{
    return {kernelProperties::kernel, kernelProperties::hOverDx};
}

Kernel::Kernel(KernelChoice choice, int dim, double hOverDx, double particleSpacing)
    : choice_(choice), dim_(dim), hOverDx_(hOverDx), h_(hOverDx * particleSpacing),
      alphaOverHDim_(std::visit([&](auto kernel) { return kernel.alpha(dim) / std::pow(h_, dim); }, choice))
{
}

Kernel Kernel::read(const Dictionary& dict, int dim, double particleSpacing)
{
    using kernelProperties::hOverDx;
    const KernelChoice kernel = choose(dict, kernelProperties::kernel, choices(), "kernel type").read();
    const double ratio = dict.scalarOr(hOverDx, dim == 2 ? 1.23 : 1.0); // the paper's
    dict.refuseUnknown(kernelPropertiesKeys());
    return {kernel, dim, ratio, particleSpacing};
}

std::string Kernel::name() const
{
    return std::visit([](auto kernel) { return std::string(kernel.name); }, choice_);
}

double Kernel::supportRadius() const
{
    return std::visit([&](auto kernel) { return kernel.supportRatio * h_; }, choice_);
}

double Kernel::W(double r) const
{
    const double q = r / h_;
    return std::visit(
        [&](auto kernel) { return q < kernel.supportRatio ? alphaOverHDim_ * kernel.f(q * q) : 0; }, choice_
    );
}

double Kernel::gradFactor(double r) const
{
    const double q = r / h_;
    return std::visit(
        [&](auto kernel)
        { return q < kernel.supportRatio ? kernel.alpha(dim_) / std::pow(h_, dim_ + 2) * kernel.dfByQ(q * q) : 0; },
        choice_
    );
}

const std::vector<Kernel::Choice>& Kernel::choices()
{
    static const auto table = tableOf(KernelChoice{});
    return table;
}

} // namespace slosh
