// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/Kernel.hpp"

#include "dictionary/Dictionary.hpp"

#include <cmath>

namespace slosh
{

namespace
{

template <std::size_t k = 0>
void appendNames(std::vector<std::string>& names)
{
    if constexpr (k < std::variant_size_v<KernelChoice>)
    {
        names.emplace_back(std::variant_alternative_t<k, KernelChoice>::name);
        appendNames<k + 1>(names);
    }
}

template <std::size_t k = 0>
KernelChoice choiceOf(const std::string& name)
{
    if constexpr (k + 1 < std::variant_size_v<KernelChoice>)
    {
        if (name != std::variant_alternative_t<k, KernelChoice>::name)
        {
            return choiceOf<k + 1>(name);
        }
    }
    return std::variant_alternative_t<k, KernelChoice>{};
}

} // namespace

Kernel::Kernel(KernelChoice choice, int dim, double hOverDx, double particleSpacing)
    : choice_(choice), dim_(dim), hOverDx_(hOverDx), h_(hOverDx * particleSpacing),
      alphaOverHDim_(std::visit([&](auto kernel) { return kernel.alpha(dim) / std::pow(h_, dim); }, choice))
{
}

Kernel Kernel::read(const Dictionary& dict, int dim, double particleSpacing)
{
    const std::string name = dict.choice("kernel", names(), "kernel type");
    const double hOverDx = dict.scalarOr("hOverDx", dim == 2 ? 1.23 : 1.0, unit::none, between(0.9, 4));
    dict.refuseUnknown();
    return {choiceOf(name), dim, hOverDx, particleSpacing};
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
    return std::visit([&](auto kernel) { return q < kernel.supportRatio ? alphaOverHDim_ * kernel.f(q * q) : 0; },
                      choice_);
}

double Kernel::gradFactor(double r) const
{
    const double q = r / h_;
    return std::visit(
        [&](auto kernel)
        { return q < kernel.supportRatio ? kernel.alpha(dim_) / std::pow(h_, dim_ + 2) * kernel.dfByQ(q * q) : 0; },
        choice_);
}

KernelChoice Kernel::choiceNamed(const std::string& name)
{
    return choiceOf(name);
}

std::vector<std::string> Kernel::names()
{
    std::vector<std::string> names;
    appendNames(names);
    return names;
}

} // namespace slosh
