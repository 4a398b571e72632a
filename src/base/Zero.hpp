// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

/// A number that is nothing: what a term that a scene leaves out returns. Adding it is no instruction; adding 0.0 is
/// one, since it makes 0 of -0 (benchmarks/neverHad).
struct Zero
{
    template <class S>
    friend S operator+(const S& x, Zero)
    {
        return x;
    }
    template <class S>
    friend Zero operator*(Zero, const S&)
    {
        return {};
    }
};

} // namespace slosh
