// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_pool.h"
#include "gl/buffer.h"
#include "gl/texel_buffer.h"

#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace vs::field {

// Where the bricks of the level that shaders see lie in the pool, what values they and their cells hold, as
// far as that is known, and which ones shaders came through. Mirrors field/shaders/bricks.glsl. All calls
// need a current context.
class BrickTable {
public:
    // A table for levels with so many bricks each, whose sides have so many cells.
    BrickTable(std::vector<std::size_t> bricksOfLevels, int cellsAlong);

    // Shaders see this level from now on, whose bricks lie so in the pool; some could not be read. Where it
    // throws, it must be called again before anything else is.
    void show(int level, const BrickPool& pool, const std::set<BrickKey>& unreadable);
    [[nodiscard]] int level() const { return level_; }

    // Place, remove and giveUp do nothing for bricks of other levels.
    void place(const BrickKey& key, glm::ivec3 slot);
    void remove(const BrickKey& key);
    void giveUp(const BrickKey& key); // it cannot be read
    // Whether a brick of the level is neither there nor given up.
    [[nodiscard]] bool isMissing(int place) const;

    // What a brick of any level holds stays known when it is no longer there. Returns whether it was unknown.
    bool noteRange(const BrickKey& key, std::uint32_t range);
    // Notes the ranges of the cells of the brick that lies in a slot now.
    void noteCells(glm::ivec3 slot, std::span<const std::uint32_t> cells);
    // The device has room for ranges of cells, which begin there.
    [[nodiscard]] bool hasCells() const { return words() > firstCell(); }
    [[nodiscard]] std::size_t firstCell() const { return 2 * bricks(); }

    // Binds texture 6 and storage 6.
    void bind() const;
    // The places of bricks that shaders came through since this was asked last, in order.
    std::vector<int> takeUses();

    [[nodiscard]] std::size_t deviceBytes() const;

private:
    [[nodiscard]] std::size_t bricks() const { return bricksOfLevels_[std::size_t(level_)]; }
    [[nodiscard]] std::size_t words() const;
    [[nodiscard]] std::vector<std::uint32_t>& rangesOf(int level);
    void setPage(const BrickKey& key, std::uint32_t page);

    std::vector<std::size_t> bricksOfLevels_;
    std::size_t cellsOfSlot_;
    int level_ = 0;
    std::size_t slotCount_ = 0;
    glm::ivec3 slots_{0};               // of the pool
    gl::TexelBuffer pages_;             // behind them the bricks' ranges, and those of all slots' cells
    gl::Buffer uses_;                   // a word for each brick
    std::vector<std::uint32_t> pageOf_; // as pages_ has them
    std::vector<std::vector<std::uint32_t>> ranges_; // of each level's bricks, once one is known
    std::vector<std::uint32_t> cells_;
};

} // namespace vs::field
