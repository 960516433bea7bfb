// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth_mirror.h"

#include "segment/growth/growth.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace vs::segment {

namespace {

constexpr std::size_t kVoxels = SeedMap::kWordsPerBrick * 32;

void widen(GenerationSpan& span, std::uint32_t generation) {
    span.first = span.first == 0 ? generation : std::min(span.first, generation);
    span.last = std::max(span.last, generation);
}

} // namespace

// As saveBrick() lays it out.
std::vector<std::byte> SeedMap::brickOf(const MirroredBrick& from) const {
    std::vector<std::uint32_t> grown(kWordsPerBrick);
    std::vector<std::uint16_t> generations(kVoxels);
    std::vector<std::uint8_t> late(isWide() ? kVoxels : 0);
    forEachVoxel(bricks_.box(from.brick), [&](glm::ivec3 voxel, std::size_t i) {
        if (from.generations[i] != 0) {
            const std::size_t bit = bitOf(voxel) - from.brick * kVoxels;
            grown[bit / 32] |= 1U << bit % 32;
            generations[bit] = std::uint16_t(from.generations[i]);
            if (!late.empty()) {
                late[bit] = std::uint8_t(from.generations[i] >> 16U);
            }
        }
    });
    std::vector<std::byte> bytes(grown.size() * 4 + generations.size() * 2 + late.size() +
                                 from.labels.size());
    std::byte* to = bytes.data();
    const auto append = [&](const auto& values) {
        const std::size_t size = values.size() * sizeof(values[0]);
        std::copy_n(reinterpret_cast<const std::byte*>(values.data()), size, to);
        to += size;
    };
    append(grown);
    append(generations);
    append(late);
    append(from.labels);
    return bytes;
}

void Growth::mirror(std::uint8_t label, const GrowthState& atWork,
                    const std::map<std::uint8_t, GrowthState>& others,
                    std::span<const MirroredBrick> bricks) {
    if (atWork.extent > SeedMap::kLongest16) {
        seedMap_.widen();
    }
    BrickTable& table = seedMap_.bricks();
    if (label != owner_.label) {
        const auto known = others_.find(label);
        others_[owner_.label].spans = table.exchangeSpans(
            known == others_.end() ? std::vector<GenerationSpan>() : std::move(known->second.spans));
    }
    for (const auto& [other, state] : others) {
        others_[other].state = state;
        others_[other].spans.resize(table.count());
    }
    others_.erase(label);
    std::vector<std::uint32_t> changed;
    for (const MirroredBrick& brick : bricks) {
        seedMap_.restoreBrick(brick.brick, seedMap_.brickOf(brick));
        std::array<GenerationSpan, 256> spans{};
        for (std::size_t i = 0; i < brick.labels.size(); ++i) {
            if (brick.generations[i] != 0) {
                widen(spans[brick.labels[i]], brick.generations[i]);
            }
        }
        table.setSpan(brick.brick, spans[label]);
        for (auto& [other, run] : others_) {
            if (!run.spans.empty()) {
                run.spans[brick.brick] = spans[other];
            }
        }
        changed.push_back(brick.brick);
    }
    table.occupy(changed);
    table.upload();
    table.markChanged(changed);
    const int before = owner_.label == label ? state_.playhead : 0;
    state_ = atWork;
    state_.playhead = before;
    owner_ = {label, hasGrownOthers()};
    movePlayhead(atWork.playhead);
    labelledRevision_ = table.revision(); // bricks came with their labels
    frontier_->invalidate();
}

} // namespace vs::segment
