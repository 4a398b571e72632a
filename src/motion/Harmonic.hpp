// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

/// What a motion has besides SolidBodyMotion where it swings as one sine of time.
class Harmonic
{
public:
    virtual ~Harmonic() = default;
    virtual double angularFrequency() const = 0; ///< omega, as the dictionary gives it, [rad/s]
};

} // namespace slosh
