// SPDX-License-Identifier: Apache-2.0
// What has grown in a brick of the finest level, as it is kept.
#include "segment/finer/fine_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace vs::segment {
namespace {

using Model = std::map<std::size_t, std::pair<std::uint32_t, std::uint8_t>>; // generation, label, by cell

void expectHolds(const FineCells& cells, const Model& model) {
    std::map<std::uint8_t, GenerationSpan> spans;
    std::array<bool, kBrickTiles> hasTile{};
    for (const auto& [cell, grown] : model) {
        ASSERT_EQ(cells.generation(cell), grown.first) << cell;
        ASSERT_EQ(cells.label(cell), grown.second) << cell;
        GenerationSpan& span =
            spans.try_emplace(grown.second, GenerationSpan{grown.first, grown.first}).first->second;
        span = {std::min(span.first, grown.first), std::max(span.last, grown.first)};
        hasTile[cell / kTileVoxels] = true;
    }
    EXPECT_EQ(cells.spans(), spans);
    for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
        EXPECT_EQ(cells.isTileEmpty(tile), !hasTile[tile]) << tile;
    }
    std::size_t count = 0;
    cells.forEachGrown([&](std::size_t cell, std::uint32_t generation) {
        ++count;
        ASSERT_TRUE(model.contains(cell));
        ASSERT_EQ(generation, model.at(cell).first);
    });
    EXPECT_EQ(count, model.size());
    cells.visitTiles([&](std::size_t tile, const auto* entries, std::uint32_t base) {
        for (std::size_t n = 0; n < kTileVoxels; ++n) {
            const auto known = model.find(tile * kTileVoxels + n);
            const std::uint32_t entry = entries[n];
            ASSERT_EQ(entry == 0 ? 0 : base + entry, known == model.end() ? 0 : known->second.first);
        }
    });
}

// What joins, portion by portion, in spans that need one byte, two and four, of one segment and of others;
// now and then, as after going back, before the first of what there is.
TEST(FineCells, WhatJoinsIsThere) {
    std::mt19937 random(11);
    const auto below = [&](std::uint32_t n) { return std::uint32_t(random() % n); };
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        const std::array<std::uint32_t, 4> longest{1, 90, 300, 60000};
        const std::uint32_t labels = 1 + below(2);
        Model model;
        std::unique_ptr<FineCells> cells;
        std::uint32_t next = 1 + below(1000);
        for (int portion = 0; portion < 5; ++portion) {
            const std::uint32_t from = below(6) == 0 ? 1 : next;
            const std::uint32_t spread = longest[below(4)];
            FineCells::Joined joined;
            joined.label = std::uint8_t(1 + below(labels));
            joined.from = from;
            std::vector<std::unique_ptr<std::array<std::uint16_t, kTileVoxels>>> lists;
            for (std::size_t tile = 0; tile < kBrickTiles; ++tile) {
                if (below(8) != 0) {
                    continue;
                }
                auto& when = *lists.emplace_back(std::make_unique<std::array<std::uint16_t, kTileVoxels>>());
                when.fill(0xabcd); // is not to be read
                FineCells::Joined::Tile one{tile, {}, when.data()};
                for (int n = 0; n < 20; ++n) {
                    const std::uint32_t place = below(kTileVoxels);
                    when[place] = std::uint16_t(below(spread));
                    if (model.try_emplace(tile * kTileVoxels + place, from + when[place], joined.label)
                            .second) {
                        slices::set(one.voxels, place);
                        const std::uint32_t generation = from + when[place];
                        GenerationSpan& span = joined.span;
                        span.first = span.first == 0 ? generation : std::min(span.first, generation);
                        span.last = std::max(span.last, generation);
                    } else if (slices::has(one.voxels, place)) {
                        when[place] = std::uint16_t(model.at(tile * kTileVoxels + place).first - from);
                    }
                }
                if (one.voxels.any() != 0) {
                    joined.tiles.push_back(one);
                }
            }
            if (joined.tiles.empty()) {
                continue;
            }
            cells = std::make_unique<FineCells>(cells.get(), joined);
            expectHolds(*cells, model);
            expectHolds(FineCells(cells->opened()), model);
            next = std::max(next, joined.span.last + 1);
        }
    }
}

} // namespace
} // namespace vs::segment
