// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace slosh
{

/// What a motion has besides SolidBodyMotion where it swings as a sine of time.
class Harmonic
{
public:
    virtual ~Harmonic() = default;
    /// omega, as the dictionary gives it, [rad/s]; nothing where that changes with time.
    virtual std::optional<double> angularFrequency() const = 0;
};

} // namespace slosh
