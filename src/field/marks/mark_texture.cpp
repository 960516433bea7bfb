// SPDX-License-Identifier: Apache-2.0
#include "field/marks/mark_texture.h"

#include "base/log.h"
#include "field/shaders/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace vs::field {

namespace {

// As marks.glsl has it: a brick's colours, then for each of its cells the coverage of the four corners that
// have the lesser z, and those of its last texels along z.
constexpr int kSide = kMarkBrick + 1;
constexpr std::size_t kColourWords = std::size_t(kSide) * kSide * kSide;
constexpr std::size_t kQuadWords = std::size_t(kMarkBrick) * kMarkBrick * kSide;
constexpr std::size_t kSlotWords = kColourWords + kQuadWords;

// A brick and the bricks behind it along the axes, by the bits of their place: 1 x, 2 y, 4 z.
using Around = std::array<const MarkBrick*, 8>;

Around around(const Marks& marks, glm::ivec3 brick) {
    const MarkGrid& grid = marks.grid();
    Around found{};
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 there = brick + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
        const bool isInside = glm::all(glm::lessThan(there, grid.bricks()));
        found[std::size_t(i)] = isInside ? marks.find(grid.placeOf(there)) : nullptr;
    }
    return found;
}

std::vector<std::uint32_t> wordsOf(const Around& bricks) {
    std::vector<std::uint32_t> words(kSlotWords);
    std::vector<std::uint8_t> coverage(kColourWords);
    forEachVoxel({glm::ivec3(0), glm::ivec3(kSide)}, [&](glm::ivec3 t, std::size_t i) {
        const glm::ivec3 beyond = t / kMarkBrick;
        const MarkBrick* brick = bricks[std::size_t(beyond.x + 2 * beyond.y + 4 * beyond.z)];
        if (brick != nullptr) {
            const std::size_t from = MarkBrick::index(t % kMarkBrick);
            const auto& c = brick->colours[from];
            words[i] = std::uint32_t(c[0]) | std::uint32_t(c[1]) << 8 | std::uint32_t(c[2]) << 16 |
                       std::uint32_t(c[3]) << 24;
            coverage[i] = brick->coverage[from];
        }
    });
    forEachVoxel(
        {glm::ivec3(0), glm::ivec3(kMarkBrick, kMarkBrick, kSide)}, [&](glm::ivec3 t, std::size_t i) {
            const std::size_t at = (std::size_t(t.z) * kSide + std::size_t(t.y)) * kSide + std::size_t(t.x);
            words[kColourWords + i] = std::uint32_t(coverage[at]) | std::uint32_t(coverage[at + 1]) << 8 |
                                      std::uint32_t(coverage[at + kSide]) << 16 |
                                      std::uint32_t(coverage[at + kSide + 1]) << 24;
        });
    return words;
}

std::size_t pagesOf(const MarkGrid& grid) {
    const glm::ivec3 n = grid.bricks();
    return std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z);
}

std::size_t mostSlots(const MarkGrid& grid) { return BrickWords::mostBricks(pagesOf(grid), kSlotWords); }

// The places in which texels of a brick may appear: its own and those before it.
void addPlacesOf(const MarkGrid& grid, std::uint32_t place, std::set<std::uint32_t>& places) {
    const glm::ivec3 brick = grid.brickAt(place);
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 there = brick - glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
        if (glm::all(glm::greaterThanEqual(there, glm::ivec3(0)))) {
            places.insert(grid.placeOf(there));
        }
    }
}

bool haveCoverage(const std::vector<std::uint32_t>& words) {
    return std::any_of(words.begin() + std::ptrdiff_t(kColourWords), words.end(),
                       [](std::uint32_t word) { return word != 0; });
}

} // namespace

bool MarkTexture::hasRoomFor(const Marks& marks) {
    const std::size_t most = mostSlots(marks.grid());
    if (8 * marks.bricks().size() <= most) {
        return true;
    }
    std::set<std::uint32_t> places;
    for (const auto& [place, brick] : marks.bricks()) {
        addPlacesOf(marks.grid(), place, places);
    }
    return std::size_t(std::count_if(places.begin(), places.end(), [&](std::uint32_t place) {
               return haveCoverage(wordsOf(around(marks, marks.grid().brickAt(place))));
           })) <= most;
}

MarkTexture::MarkTexture() : words_(kSlotWords, "marks") {}

void MarkTexture::forget() {
    words_.forget();
    shown_ = std::make_shared<const Marks>();
}

BrickWords::Changes MarkTexture::changes(const Marks& before, const Marks& marks) const {
    std::set<std::uint32_t> places;
    for (const std::uint32_t changed : changedBricks(before, marks)) {
        addPlacesOf(marks.grid(), changed, places);
    }
    BrickWords::Changes found;
    for (const std::uint32_t place : places) {
        BrickWords::Words words = wordsOf(around(marks, marks.grid().brickAt(place)));
        if (!haveCoverage(words)) {
            words.clear();
        }
        if (!words.empty() || words_.isHeld(place)) {
            found[place] = {std::move(words)};
        }
    }
    return found;
}

void MarkTexture::show(const SharedMarks& marks) {
    if (shown_ == marks) {
        return;
    }
    if (marks->isEmpty()) {
        forget();
        return;
    }
    if (!(grid_ == marks->grid())) {
        forget();
        grid_ = marks->grid();
    }
    std::size_t tooMany = 0;
    try {
        tooMany = words_.update(pagesOf(grid_),
                                [&](bool isAll) { return changes(isAll ? Marks() : *shown_, *marks); });
    } catch (...) { // half of them are there
        forget();
        throw;
    }
    if (tooMany > 0) {
        if (!std::exchange(hasComplained_, true)) {
            logNotice(fmt::format("there are marks in {} bricks, and this device has room for {}: they are "
                                  "not shown",
                                  tooMany, mostSlots(grid_)));
        }
        forget();
        return;
    }
    shown_ = marks;
}

void MarkTexture::bind(const volume::GridGeometry& geometry) const {
    words_.bindTexture(kMarksTexture);
    if (!block_) {
        block_ = gl::Buffer(sizeof(MarksBlock), "where marks lie");
    }
    const double perStep = geometry.stepMm() / grid_.texelMm(geometry);
    block_.writeValue(MarksBlock{glm::ivec4(grid_.bricks(), int(words_.firstWord())),
                                 glm::vec4(glm::vec3(grid_.perVoxel), float(perStep))});
    block_.bindUniform(kMarksBlock);
}

} // namespace vs::field
