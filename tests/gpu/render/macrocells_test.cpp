// SPDX-License-Identifier: Apache-2.0
// Distances of macrocells against every pair of cells looked at.
#include "gpu/gl_test.h"
#include "render/space/macrocells.h"

#include <algorithm>
#include <random>
#include <vector>

namespace vs::render {
namespace {

using glm::ivec3;

class MacrocellsTest : public test::GlTest {};

gl::Texture cellsFrom(ivec3 size, const std::vector<bool>& marked) {
    std::vector<glm::vec2> ranges;
    for (const bool isMarked : marked) {
        ranges.emplace_back(isMarked ? glm::vec2(0.2F, 0.9F) : glm::vec2(0.1F, 0.2F));
    }
    gl::Texture cells(size, gl::Format::RG32F, gl::Filter::Nearest, "cells");
    cells.upload({ivec3(0), size}, std::as_bytes(std::span(ranges)));
    return cells;
}

std::vector<std::uint32_t> byEveryPair(ivec3 size, const std::vector<bool>& marked) {
    const auto placeOf = [&](std::size_t n) {
        const int i = int(n);
        return ivec3(i % size.x, i / size.x % size.y, i / (size.x * size.y));
    };
    std::vector<std::uint32_t> distances(marked.size(), Macrocells::kFar);
    for (std::size_t from = 0; from < marked.size(); ++from) {
        for (std::size_t to = 0; marked[from] && to < marked.size(); ++to) {
            const ivec3 apart = glm::abs(placeOf(from) - placeOf(to));
            const auto steps = std::uint32_t(std::max({apart.x, apart.y, apart.z}));
            distances[to] = std::min(distances[to], steps);
        }
    }
    return distances;
}

// Sizes around those of the blocks of bits, and longer than any distance counts.
TEST_F(MacrocellsTest, DistancesAreThoseToTheNearestMarkedCell) {
    std::mt19937 random(7);
    for (const ivec3 size :
         {ivec3(1), ivec3(31, 3, 2), ivec3(32, 4, 1), ivec3(33, 5, 7), ivec3(70, 30, 3), ivec3(5, 61, 29)}) {
        for (const double share : {0.0, 0.0005, 0.02}) {
            std::vector<bool> marked(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
            for (std::size_t i = 0; i < marked.size(); ++i) {
                marked[i] = std::bernoulli_distribution(share)(random);
            }
            const gl::Texture cells = cellsFrom(size, marked);
            Macrocells macrocells;
            macrocells.rebuild({.dataCells = &cells, .visibleRange = {0.5, 1.0}});
            EXPECT_EQ(macrocells.distances().downloadAll<std::uint32_t>(), byEveryPair(size, marked))
                << size.x << " x " << size.y << " x " << size.z << ", " << share;
        }
    }
}

} // namespace
} // namespace vs::render
