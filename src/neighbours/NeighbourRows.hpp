// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slosh
{

/// The record of particle i. After each 32768 particles, and after the last one, there is a padding record, out of
/// reach of all particles: from any neighbour an offset of two bytes reaches one.
constexpr std::ptrdiff_t recordOf(std::ptrdiff_t particle)
{
    return particle + (particle >> 15);
}
/// The particle that has this record, which is no padding.
constexpr std::ptrdiff_t particleOf(std::ptrdiff_t record)
{
    return record - record / ((1 << 15) + 1);
}
inline constexpr std::ptrdiff_t recordsPerStretch = recordOf(1 << 15); ///< the last of them is padding

/// Neighbours are kept in groups of this many, a multiple of the lanes that a loop takes at a time.
constexpr int neighboursPerGroup(int lanes)
{
    return std::max(lanes, 8);
}

/// For each particle the records of its neighbours, in groups: in a group a record is first + offset, of two bytes,
/// since particles near to each other stand near to each other in memory too. Half of what whole indices take. Groups
/// that are not full are filled up with a padding record. Rows are kept by blocks, which threads fill
/// independently.
class NeighbourRows
{
public:
    struct Row
    {
        const int* first;
        const std::uint16_t* offset; ///< neighboursPerGroup(lanes) for each group
        std::ptrdiff_t groups;
        std::ptrdiff_t before; ///< groups that hold none of the second part
    };
    static constexpr std::ptrdiff_t rowsPerBlock = 64;

    /// For `particles` rows, all empty, whose records are read `lanes` at a time.
    void reset(std::ptrdiff_t particles, int lanes);

    /// Sets the rows of block number `block`: rows[ends[k-1], ends[k]) are the records of the k-th row's neighbours,
    /// those of its second part from parts[k] on.
    void setBlock(
        std::ptrdiff_t block, std::span<const int> rows, std::span<const std::ptrdiff_t> parts,
        std::span<const std::ptrdiff_t> ends
    );

    Row row(std::ptrdiff_t i) const
    {
        const Block& block = blocks_[i / rowsPerBlock];
        const std::size_t k = static_cast<std::size_t>(i % rowsPerBlock);
        const int begin = k == 0 ? 0 : block.end[k - 1];
        return {
            block.first.data() + begin, block.offset.data() + static_cast<std::ptrdiff_t>(begin) * width_,
            block.end[k] - begin, block.part[k] - begin};
    }

    int width() const { return width_; } ///< neighbours a group
    std::size_t bytes() const;

private:
    struct Block
    {
        std::vector<int> first;
        std::vector<std::uint16_t> offset;
        std::array<int, rowsPerBlock> part{}; ///< where each row's second part begins, in groups
        std::array<int, rowsPerBlock> end{};  ///< of each row, in groups
    };
    int width_ = neighboursPerGroup(1);
    std::ptrdiff_t particles_ = 0;
    std::vector<Block> blocks_;
};

} // namespace slosh
