// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary/Choice.hpp"
#include "kernels/KernelChoice.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// A kernel with its smoothing length, chosen at run time; double precision. The pair loops take the type itself.
class Kernel
{
public:
    Kernel(KernelChoice choice, int dim, double smoothingLength) : Kernel(choice, dim, smoothingLength, 1) {}
    Kernel(KernelChoice choice, int dim, double hOverDx, double particleSpacing);

    /// constant/kernelProperties.
    static Kernel read(const Dictionary& kernelProperties, int dim, double particleSpacing);

    /// The same h/dx at another spacing.
    Kernel withSpacing(double particleSpacing) const { return {choice_, dim_, hOverDx_, particleSpacing}; }

    const KernelChoice& choice() const { return choice_; }
    std::string name() const;
    int dim() const { return dim_; }
    double smoothingLength() const { return h_; } ///< h, [m]
    double supportRadius() const;                 ///< 2h or 3h, [m]

    double W(double r) const;          ///< W(r), [1/m^dim]
    double gradFactor(double r) const; ///< (1/r) dW/dr: grad_a W_ab = gradFactor(|r_ab|) r_ab, [1/m^(dim+2)]

    /// Those of KernelChoice by their names.
    using Choice = slosh::Choice<KernelChoice (*)()>;
    static const std::vector<Choice>& choices();
    static std::vector<std::string> names() { return namesOf(choices()); }
    /// The kernel called `name`, one of names().
    static KernelChoice choiceNamed(const std::string& name) { return slosh::choiceNamed(choices(), name).read(); }

private:
    KernelChoice choice_;
    int dim_;
    double hOverDx_;
    double h_;
    double alphaOverHDim_; ///< W(r) = alphaOverHDim_ f(q)
};

/// All entries of constant/kernelProperties.
Keys kernelPropertiesKeys();

} // namespace slosh
