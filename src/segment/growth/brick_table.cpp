// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/brick_table.h"

#include "field/field.h"

#include <limits>

namespace vs::segment {

BrickTable::BrickTable(glm::ivec3 dims) : dims_(dims), brickDims_(divideUp(dims, field::kBrick)) {
    const auto count = std::size_t(brickDims_.x) * std::size_t(brickDims_.y) * std::size_t(brickDims_.z);
    onDevice_ = gl::Buffer(count * sizeof(GenerationSpan), "growth bricks");
    spans_.resize(count);
    changedAt_.resize(count);
    isOccupied_.resize(count, false);
}

glm::ivec3 BrickTable::brickAt(std::uint32_t brick) const {
    const int i = int(brick);
    return {i % brickDims_.x, i / brickDims_.x % brickDims_.y, i / (brickDims_.x * brickDims_.y)};
}

Box3 BrickTable::box(std::uint32_t brick) const {
    const glm::ivec3 lo = brickAt(brick) * field::kBrick;
    return {lo, glm::min(lo + field::kBrick, dims_)};
}

std::uint32_t BrickTable::brickOf(glm::ivec3 voxel) const {
    const glm::ivec3 brick = voxel / field::kBrick;
    return std::uint32_t((brick.z * brickDims_.y + brick.y) * brickDims_.x + brick.x);
}

std::vector<std::uint32_t> BrickTable::holding(int after, int upTo) const {
    std::vector<std::uint32_t> bricks;
    for (std::uint32_t i = 0; i < spans_.size(); ++i) {
        if (spans_[i].first != 0 && std::int64_t(spans_[i].first) <= upTo &&
            std::int64_t(spans_[i].last) > after) {
            bricks.push_back(i);
        }
    }
    return bricks;
}

void BrickTable::download() { spans_ = onDevice_.read<GenerationSpan>(spans_.size()); }

void BrickTable::upload() { onDevice_.write(std::span<const GenerationSpan>(spans_)); }

void BrickTable::add(glm::ivec3 voxel, int generation) {
    const std::uint32_t brick = brickOf(voxel);
    widen(std::span(&brick, 1), generation);
}

void BrickTable::widen(std::span<const std::uint32_t> bricks, int generation) {
    for (const std::uint32_t brick : bricks) {
        GenerationSpan& span = spans_[brick];
        span.first = span.first == 0 ? std::uint32_t(generation) : span.first;
        span.last = std::uint32_t(generation);
    }
}

std::vector<GenerationSpan> BrickTable::exchangeSpans(std::vector<GenerationSpan> spans) {
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        isOccupied_[i] = isOccupied_[i] || spans_[i].first != 0;
    }
    spans.resize(spans_.size());
    spans_.swap(spans);
    return spans;
}

void BrickTable::occupy(const std::vector<std::uint32_t>& bricks) {
    for (const std::uint32_t brick : bricks) {
        isOccupied_[brick] = true;
    }
}

void BrickTable::truncate(int last) {
    const auto limit = std::uint32_t(last);
    for (GenerationSpan& span : spans_) {
        span = span.first > limit ? GenerationSpan{} : GenerationSpan{span.first, std::min(span.last, limit)};
    }
}

std::vector<std::uint32_t> BrickTable::touched() const { return holding(0, std::numeric_limits<int>::max()); }

std::vector<std::uint32_t> BrickTable::occupied() const {
    std::vector<std::uint32_t> bricks;
    for (std::uint32_t i = 0; i < spans_.size(); ++i) {
        if (isOccupied(i)) {
            bricks.push_back(i);
        }
    }
    return bricks;
}

std::vector<std::uint32_t> BrickTable::changedSince(std::uint64_t revision) const {
    std::vector<std::uint32_t> bricks;
    for (std::uint32_t i = 0; i < changedAt_.size(); ++i) {
        if (changedAt_[i] > revision) {
            bricks.push_back(i);
        }
    }
    return bricks;
}

void BrickTable::markChanged(const std::vector<std::uint32_t>& bricks) {
    if (bricks.empty()) {
        return;
    }
    ++revision_;
    for (const std::uint32_t brick : bricks) {
        changedAt_[brick] = revision_;
    }
}

} // namespace vs::segment
