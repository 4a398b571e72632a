#include "neighbours/VerletSkin.hpp"

#include "base/parallel.hpp"

#include <cmath>
#include <utility>

namespace slosh
{

void VerletSkin::listBuilt(std::span<const Vec> positions, double skin)
{
    skin_ = skin;
    listed_.resize(positions.size());
    parallelFor(static_cast<std::ptrdiff_t>(positions.size()), [&](std::ptrdiff_t i)
                { listed_[static_cast<std::size_t>(i)] = positions[static_cast<std::size_t>(i)]; });
}

bool VerletSkin::mustRebuild(std::span<const Vec> positions, double allowance) const
{
    if (listed_.size() != positions.size())
    {
        return true;
    }
    using LargestTwo = std::pair<double, double>; // squares, descending
    const auto insert = [](LargestTwo two, double d2)
    { return d2 > two.first ? LargestTwo(d2, two.first) : LargestTwo(two.first, std::max(two.second, d2)); };
    const auto [first, second] = parallelReduce(
        static_cast<std::ptrdiff_t>(positions.size()), LargestTwo(0, 0),
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            LargestTwo two(0, 0);
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const auto k = static_cast<std::size_t>(i);
                two = insert(two, (positions[k] - listed_[k]).squaredNorm());
            }
            return two;
        },
        [&](const LargestTwo& a, const LargestTwo& b) { return insert(insert(a, b.first), b.second); });
    return std::sqrt(first) + std::sqrt(second) + allowance > skin_;
}

} // namespace slosh
