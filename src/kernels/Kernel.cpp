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

} // namespace

Kernel::Kernel(KernelChoice choice, int dim, double hOverDx, double particleSpacing)
    : choice_(choice), dim_(dim), hOverDx_(hOverDx), h_(hOverDx * particleSpacing),
      alphaOverHDim_(std::visit([&](auto kernel) { return kernel.alpha(dim) / std::pow(h_, dim); }, choice))
{
}

Kernel Kernel::read(const Dictionary& dict, int dim, double particleSpacing)
{
    const KernelChoice kernel = choose(dict, "kernel", choices(), "kernel type").read();
    const double hOverDx = dict.scalarOr("hOverDx", dim == 2 ? 1.23 : 1.0, unit::none, between(0.9, 4));
    dict.refuseUnknown();
    return {kernel, dim, hOverDx, particleSpacing};
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
