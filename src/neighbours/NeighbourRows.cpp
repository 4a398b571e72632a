// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/NeighbourRows.hpp"

#include <limits>
#include <utility>

namespace slosh
{

namespace
{

constexpr int longestOffset = 65535;

/// The first padding record at or after `record`, of those for `particles` particles.
int paddingAfter(int record, std::ptrdiff_t particles)
{
    const std::ptrdiff_t endOfStretch = (record / recordsPerStretch + 1) * recordsPerStretch - 1;
    return static_cast<int>(std::min(endOfStretch, recordOf(particles)));
}

/// Least and largest; vectorised, as std::minmax_element is not.
std::pair<int, int> extremes(const int* begin, const int* end)
{
    int low = std::numeric_limits<int>::max(), high = 0;
    for (const int* k = begin; k != end; ++k)
    {
        low = std::min(low, *k);
        high = std::max(high, *k);
    }
    return {low, high};
}

} // namespace

void NeighbourRows::reset(std::ptrdiff_t particles, int lanes)
{
    width_ = neighboursPerGroup(lanes);
    particles_ = particles;
    blocks_.resize((particles + rowsPerBlock - 1) / rowsPerBlock);
}

void NeighbourRows::setBlock(
    std::ptrdiff_t block, std::span<const int> rows, std::span<const std::ptrdiff_t> parts,
    std::span<const std::ptrdiff_t> ends
)
{
    std::vector<int> firsts;
    std::vector<std::uint16_t> offsets;
    firsts.reserve(rows.size() / static_cast<std::size_t>(width_) + 2 * ends.size());
    offsets.reserve(rows.size() + 2 * ends.size() * static_cast<std::size_t>(width_));
    Block& target = blocks_[block];
    const int* next = rows.data();
    for (std::size_t row = 0; row < ends.size(); ++row)
    {
        const int* const end = rows.data() + ends[row];
        const auto [lowest, highest] = extremes(next, end);
        const int* const part = rows.data() + parts[row];
        target.part[row] = -1;
        while (next != end)
        {
            const int* const groupEnd = next + std::min<std::ptrdiff_t>(width_, end - next);
            const bool fits = highest - lowest <= longestOffset; // nearly always: one first for the whole row
            int low = fits ? lowest : *next, high = *next;
            const int* last = fits ? groupEnd : next + 1;
            for (; last != groupEnd; ++last)
            {
                const int lower = std::min(low, *last), higher = std::max(high, *last);
                if (higher - lower > longestOffset)
                {
                    break;
                }
                low = lower;
                high = higher;
            }
            if (target.part[row] < 0 && last > part)
            {
                target.part[row] = static_cast<int>(firsts.size());
            }
            firsts.push_back(low);
            const std::size_t full = offsets.size() + static_cast<std::size_t>(width_);
            offsets.resize(full, static_cast<std::uint16_t>(paddingAfter(low, particles_) - low));
            std::transform(
                next, last, offsets.end() - width_,
                [low](int record) { return static_cast<std::uint16_t>(record - low); }
            );
            next = last;
        }
        target.end[row] = static_cast<int>(firsts.size());
        target.part[row] = target.part[row] < 0 ? target.end[row] : target.part[row];
    }
    // Exactly as long as they must be: growing vectors would keep twice that.
    target.first.assign(firsts.begin(), firsts.end());
    target.offset.assign(offsets.begin(), offsets.end());
}

std::size_t NeighbourRows::bytes() const
{
    std::size_t bytes = blocks_.capacity() * sizeof(Block);
    for (const Block& block : blocks_)
    {
        bytes += block.first.capacity() * sizeof(int) + block.offset.capacity() * sizeof(std::uint16_t);
    }
    return bytes;
}

} // namespace slosh
