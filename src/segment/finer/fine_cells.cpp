// SPDX-License-Identifier: Apache-2.0
#include "segment/finer/fine_cells.h"

#include <algorithm>
#include <limits>

namespace vs::segment {

FineCells::FineCells(const OpenCells& open) {
    std::array<GenerationSpan, 256> spans{};
    for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
        const std::size_t slot = open.slots_.slotOf(tile);
        bool isAny = false;
        for (std::size_t n = 0; slot > 0 && n < kTileVoxels; ++n) {
            const std::size_t place = (slot - 1) * kTileVoxels + n;
            if (const std::uint32_t generation = open.generations_[place]; generation != 0) {
                GenerationSpan& span = spans[open.labels_[place]];
                span.first = span.first == 0 ? generation : std::min(span.first, generation);
                span.last = std::max(span.last, generation);
                isAny = true;
            }
        }
        if (isAny) {
            slots_.add(tile);
        }
    }
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t last = 0;
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
    setEntries(last, [&]<typename Entry>(Entry /*kind*/) { return entriesOf<Entry>(open); });
    if (spans_.size() == 1) {
        labels_ = {spans_.begin()->first};
        return;
    }
    labels_.reserve(slots_.count() * kTileVoxels);
    for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
        if (!isTileEmpty(tile)) {
            const auto own = open.labels_.begin() + std::ptrdiff_t(open.slots_.placeOf(tile * kTileVoxels));
            labels_.insert(labels_.end(), own, own + std::ptrdiff_t(kTileVoxels));
        }
    }
}

FineCells::FineCells(const FineCells* before, const Joined& joined) {
    const bool isAlone = before == nullptr || before->isEmpty();
    if (!isAlone && (before->spans_.size() > 1 || before->spans_.begin()->first != joined.label ||
                     joined.span.first <= before->base_)) {
        OpenCells open = before->opened();
        for (const Joined::Tile& tile : joined.tiles) {
            slices::forEach(tile.voxels, [&](std::uint32_t place) {
                open.set(tile.tile * kTileVoxels + place, joined.from + tile.when[place], joined.label);
            });
        }
        *this = FineCells(open);
        return;
    }
    GenerationSpan span = joined.span;
    if (!isAlone) {
        const GenerationSpan old = before->spans_.begin()->second;
        span = {std::min(old.first, span.first), std::max(old.last, span.last)};
        slots_ = before->slots_;
    }
    for (const Joined::Tile& tile : joined.tiles) {
        if (isTileEmpty(tile.tile)) {
            slots_.add(tile.tile);
        }
    }
    spans_.emplace(joined.label, span);
    labels_ = {joined.label};
    base_ = isAlone ? span.first - 1 : before->base_;
    setEntries(span.last, [&]<typename Entry>(Entry /*kind*/) {
        std::vector<Entry> entries(slots_.count() * kTileVoxels);
        if (!isAlone) { // of the tiles that were there, whose slots come first
            std::visit([&](const auto& old) { std::copy(old.begin(), old.end(), entries.begin()); },
                       before->entries_);
        }
        add(joined, entries);
        return entries;
    });
}

// In as few bytes as generations up to the last one need: of what `entriesOf` makes of an entry of a type.
template <typename F>
void FineCells::setEntries(std::uint32_t last, F&& entriesOf) {
    const std::uint32_t most = last - base_;
    if (most <= std::numeric_limits<std::uint8_t>::max()) {
        entries_ = entriesOf(std::uint8_t());
        return;
    }
    if (most <= std::numeric_limits<std::uint16_t>::max()) {
        entries_ = entriesOf(std::uint16_t());
        return;
    }
    entries_ = entriesOf(std::uint32_t());
}

template <typename Entry>
void FineCells::add(const Joined& joined, std::vector<Entry>& entries) const {
    const std::uint32_t from = joined.from - base_;
    for (const Joined::Tile& tile : joined.tiles) {
        Entry* const own = entries.data() + slots_.placeOf(tile.tile * kTileVoxels);
        slices::forEach(tile.voxels,
                        [&](std::uint32_t place) { own[place] = Entry(from + tile.when[place]); });
    }
}

template <typename Entry>
std::vector<Entry> FineCells::entriesOf(const OpenCells& open) const {
    std::vector<Entry> entries;
    entries.reserve(slots_.count() * kTileVoxels);
    for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
        if (!isTileEmpty(tile)) {
            const auto own =
                open.generations_.begin() + std::ptrdiff_t(open.slots_.placeOf(tile * kTileVoxels));
            std::transform(own, own + std::ptrdiff_t(kTileVoxels), std::back_inserter(entries),
                           [&](std::uint32_t g) { return g == 0 ? Entry(0) : Entry(g - base_); });
        }
    }
    return entries;
}

OpenCells FineCells::opened() const {
    OpenCells open;
    open.slots_ = slots_;
    std::visit(
        [&](const auto& entries) {
            open.generations_.resize(entries.size());
            std::transform(entries.begin(), entries.end(), open.generations_.begin(), [&](auto entry) {
                return entry == 0 ? 0U : std::uint32_t(base_ + std::uint32_t(entry));
            });
        },
        entries_);
    open.labels_.assign(open.generations_.size(), labels_.empty() ? std::uint8_t(0) : labels_.front());
    if (labels_.size() > 1) {
        open.labels_ = labels_;
    }
    return open;
}

std::size_t FineCells::bytes() const {
    return sizeof(*this) + labels_.size() +
           std::visit([](const auto& entries) { return entries.size() * sizeof(entries[0]); }, entries_);
}

} // namespace vs::segment
