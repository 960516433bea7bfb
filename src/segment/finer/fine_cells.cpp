// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_cells.h"

#include <algorithm>
#include <limits>

namespace vs::segment {

namespace {

template <typename Entry>
std::vector<Entry> entriesOf(const std::vector<std::uint32_t>& generations, std::uint32_t base) {
    std::vector<Entry> entries(generations.size());
    std::transform(generations.begin(), generations.end(), entries.begin(),
                   [&](std::uint32_t g) { return g == 0 ? Entry(0) : Entry(g - base); });
    return entries;
}

} // namespace

FineCells::FineCells(const OpenCells& open) {
    std::array<GenerationSpan, 256> spans{};
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t last = 0;
    for (std::size_t cell = 0; cell < kBrickVoxels; ++cell) {
        const std::uint32_t generation = open.generations[cell];
        if (generation != 0) {
            GenerationSpan& span = spans[open.labels[cell]];
            span.first = span.first == 0 ? generation : std::min(span.first, generation);
            span.last = std::max(span.last, generation);
        }
    }
    for (std::size_t label = 0; label < spans.size(); ++label) {
        if (spans[label].first != 0) {
            spans_.emplace(std::uint8_t(label), spans[label]);
            first = std::min(first, spans[label].first);
            last = std::max(last, spans[label].last);
        }
    }
    if (spans_.empty()) {
        return;
    }
    base_ = first - 1;
    if (last - base_ <= std::numeric_limits<std::uint8_t>::max()) {
        entries_ = entriesOf<std::uint8_t>(open.generations, base_);
    } else if (last - base_ <= std::numeric_limits<std::uint16_t>::max()) {
        entries_ = entriesOf<std::uint16_t>(open.generations, base_);
    } else {
        entries_ = entriesOf<std::uint32_t>(open.generations, base_);
    }
    labels_ = spans_.size() == 1 ? std::vector<std::uint8_t>{spans_.begin()->first} : open.labels;
}

OpenCells FineCells::opened() const {
    OpenCells open;
    std::visit(
        [&](const auto& entries) {
            for (std::size_t cell = 0; cell < entries.size(); ++cell) {
                const std::uint32_t entry = entries[cell];
                open.generations[cell] = entry == 0 ? 0 : base_ + entry;
            }
        },
        entries_);
    if (labels_.size() == 1) {
        std::fill(open.labels.begin(), open.labels.end(), labels_.front());
    } else if (!labels_.empty()) {
        open.labels = labels_;
    }
    return open;
}

std::size_t FineCells::bytes() const {
    return sizeof(*this) + labels_.size() +
           std::visit([](const auto& entries) { return entries.size() * sizeof(entries[0]); }, entries_);
}

} // namespace vs::segment
