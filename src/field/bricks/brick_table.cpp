// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_table.h"

#include "field/bricks/brick_ranges.h"
#include "field/shaders/bindings.h"

#include <algorithm>
#include <utility>

namespace vs::field {

namespace {

// What a page says of a brick: mirrors field/shaders/bricks.glsl.
constexpr std::uint32_t kNotThere = 0;
constexpr std::uint32_t kNotReadable = 1;
std::uint32_t pageOf(glm::ivec3 slot) {
    return 0x80000000U | std::uint32_t(slot.x) | std::uint32_t(slot.y) << 10 | std::uint32_t(slot.z) << 20;
}

} // namespace

BrickTable::BrickTable(std::vector<std::size_t> bricksOfLevels, int cellsAlong)
    : bricksOfLevels_(std::move(bricksOfLevels)),
      cellsOfSlot_(std::size_t(cellsAlong) * std::size_t(cellsAlong) * std::size_t(cellsAlong)) {
    ranges_.resize(bricksOfLevels_.size());
}

// Pages and ranges of the level's bricks, and the ranges of cells, if the device has room for those too.
std::size_t BrickTable::words() const {
    const std::size_t all = firstCell() + slotCount_ * cellsOfSlot_;
    return all <= gl::TexelBuffer::mostTexels() ? all : firstCell();
}

void BrickTable::show(int level, const BrickPool& pool, const std::set<BrickKey>& unreadable) {
    level_ = level;
    pageOf_.assign(bricks(), kNotThere);
    for (const BrickKey& key : unreadable) {
        if (key.level == level_) {
            pageOf_[std::size_t(key.place)] = kNotReadable;
        }
    }
    pool.forEach([&](const BrickKey& key, glm::ivec3 slot) {
        if (key.level == level_) {
            pageOf_[std::size_t(key.place)] = pageOf(slot);
        }
    });
    if (pool.slotCounts() != slots_) { // none of them has been filled
        slots_ = pool.slotCounts();
        slotCount_ = pool.slotCount();
        cells_.assign(slotCount_ * cellsOfSlot_, kAnyValue);
    }
    if (pages_.texels() < words()) {
        pages_ = gl::TexelBuffer(words(), gl::Format::R32UI, "pages of bricks");
    }
    if (uses_.size() < bricks() * sizeof(std::uint32_t)) {
        uses_ = gl::Buffer(bricks() * sizeof(std::uint32_t), "uses of bricks");
    }
    pages_.write(std::as_bytes(std::span(pageOf_)), 0);
    pages_.write(std::as_bytes(std::span(rangesOf(level_))), bricks());
    if (hasCells()) {
        pages_.write(std::as_bytes(std::span(cells_)), firstCell());
    }
    uses_.clear();
}

std::vector<std::uint32_t>& BrickTable::rangesOf(int level) {
    auto& ranges = ranges_[std::size_t(level)];
    ranges.resize(bricksOfLevels_[std::size_t(level)], kAnyValue); // the finest ones may have very many
    return ranges;
}

void BrickTable::setPage(const BrickKey& key, std::uint32_t page) {
    if (key.level == level_) {
        pageOf_[std::size_t(key.place)] = page;
        pages_.write(std::as_bytes(std::span(&page, 1)), std::size_t(key.place));
    }
}

void BrickTable::place(const BrickKey& key, glm::ivec3 slot) { setPage(key, pageOf(slot)); }
void BrickTable::remove(const BrickKey& key) { setPage(key, kNotThere); }
void BrickTable::giveUp(const BrickKey& key) { setPage(key, kNotReadable); }

bool BrickTable::isMissing(int place) const { return pageOf_[std::size_t(place)] == kNotThere; }

bool BrickTable::noteRange(const BrickKey& key, std::uint32_t range) {
    std::uint32_t& known = rangesOf(key.level)[std::size_t(key.place)];
    const bool isNew = known == kAnyValue && range != kAnyValue;
    known = range;
    if (key.level == level_) {
        pages_.write(std::as_bytes(std::span(&range, 1)), bricks() + std::size_t(key.place));
    }
    return isNew;
}

void BrickTable::noteCells(glm::ivec3 slot, std::span<const std::uint32_t> cells) {
    const auto number = std::size_t((slot.z * slots_.y + slot.y) * slots_.x + slot.x);
    std::copy(cells.begin(), cells.end(), cells_.begin() + std::ptrdiff_t(number * cellsOfSlot_));
    if (hasCells()) {
        pages_.write(std::as_bytes(cells), firstCell() + number * cellsOfSlot_);
    }
}

void BrickTable::bind() const {
    pages_.bindTexture(kBrickPagesTexture);
    uses_.bindStorage(kBrickUsesStorage);
}

std::vector<int> BrickTable::takeUses() {
    const auto uses = uses_.read<std::uint32_t>(bricks());
    uses_.clear();
    std::vector<int> used;
    for (int place = 0; place < int(uses.size()); ++place) {
        if (uses[std::size_t(place)] != 0) {
            used.push_back(place);
        }
    }
    return used;
}

std::size_t BrickTable::deviceBytes() const { return pages_.texels() * sizeof(std::uint32_t) + uses_.size(); }

} // namespace vs::field
