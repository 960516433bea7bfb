// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/growth_mirror.h"

#include "base/parallel.h"
#include "segment/growth/growth.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace vs::segment {

namespace {

void widen(GenerationSpan& span, std::uint32_t generation) {
    span.first = span.first == 0 ? generation : std::min(span.first, generation);
    span.last = std::max(span.last, generation);
}

} // namespace

void SeedMap::layOut(std::uint32_t brick, const MirroredBrick& from, std::vector<std::byte>& bytes) const {
    const std::size_t lateBytes = isWide() ? kLateBytes : 0;
    bytes.assign(kGrownBytes + kGenerationBytes + lateBytes + from.labels.size(), std::byte(0));
    auto* const grown = reinterpret_cast<std::uint32_t*>(bytes.data());
    auto* const generations = reinterpret_cast<std::uint16_t*>(bytes.data() + kGrownBytes);
    auto* const late = reinterpret_cast<std::uint8_t*>(bytes.data() + kGrownBytes + kGenerationBytes);
    const Box3 box = bricks_.box(brick);
    const glm::uvec3 size(box.size());
    forEachLabelled(from.labels, [&](std::size_t i) {
        const auto n = std::uint32_t(i);
        const glm::uvec3 inBrick(n % size.x, n / size.x % size.y, n / (size.x * size.y));
        const std::size_t bit = bitInBrick(inBrick);
        grown[bit / 32] |= 1U << bit % 32;
        generations[bit] = std::uint16_t(from.generations[i]);
        if (lateBytes > 0) {
            late[bit] = std::uint8_t(from.generations[i] >> 16U);
        }
    });
    std::copy_n(reinterpret_cast<const std::byte*>(from.labels.data()), from.labels.size(),
                bytes.end() - std::ptrdiff_t(from.labels.size()));
}

void Growth::mirror(std::uint8_t label, const GrowthState& atWork,
                    const std::map<std::uint8_t, GrowthState>& others, std::span<const std::uint32_t> bricks,
                    const MirrorOf& told) {
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
    // Some together, so that lists are made once and not for each brick.
    struct Mirrored {
        MirroredBrick told;
        std::vector<std::byte> bytes;
        std::array<GenerationSpan, 256> spans{};
    };
    constexpr std::size_t kTogether = 64;
    std::vector<Mirrored> group(std::min(kTogether, bricks.size()));
    for (std::size_t first = 0; first < bricks.size(); first += kTogether) {
        const auto some = bricks.subspan(first, std::min(kTogether, bricks.size() - first));
        inParallel(int(some.size()), [&](int n) {
            Mirrored& one = group[std::size_t(n)];
            told(some[std::size_t(n)], one.told);
            seedMap_.layOut(some[std::size_t(n)], one.told, one.bytes);
            one.spans.fill({});
            forEachLabelled(one.told.labels, [&](std::size_t i) {
                widen(one.spans[one.told.labels[i]], one.told.generations[i]);
            });
        });
        for (std::size_t n = 0; n < some.size(); ++n) {
            seedMap_.restoreBrick(some[n], group[n].bytes);
            table.setSpan(some[n], group[n].spans[label]);
            for (auto& [other, run] : others_) {
                if (!run.spans.empty()) {
                    run.spans[some[n]] = group[n].spans[other];
                }
            }
        }
    }
    const std::vector<std::uint32_t> changed(bricks.begin(), bricks.end());
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
