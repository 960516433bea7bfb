// SPDX-License-Identifier: Apache-2.0
#include "field/marks/mark_texture.h"

#include "base/log.h"
#include "field/shaders/bindings.h"
#include "gl/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>

namespace vs::field {

namespace {

// As marks.glsl has it: a brick's colours, then for each of its cells the coverage of the four corners that
// have the lesser z, and those of its last texels along z.
constexpr int kSide = kMarkBrick + 1;
constexpr std::size_t kColourWords = std::size_t(kSide) * kSide * kSide;
constexpr std::size_t kQuadWords = std::size_t(kMarkBrick) * kMarkBrick * kSide;
constexpr std::size_t kSlotWords = kColourWords + kQuadWords;
constexpr std::size_t kFirstSlots = 16;

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

std::size_t mostSlots(const MarkGrid& grid) {
    const std::size_t most =
        std::min(gl::TexelBuffer::mostTexels(), gl::limits().storageBlockBytes / sizeof(std::uint32_t));
    return most > pagesOf(grid) ? (most - pagesOf(grid)) / kSlotWords : 0;
}

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

void MarkTexture::forget() {
    slots_.clear();
    free_.clear();
    used_ = 0;
    capacity_ = 0;
    words_ = gl::TexelBuffer();
    shown_ = std::make_shared<const Marks>();
}

void MarkTexture::begin(const MarkGrid& grid, std::size_t slots) {
    forget();
    grid_ = grid;
    words_ = gl::TexelBuffer(pagesOf(grid) + slots * kSlotWords, gl::Format::R32UI, "marks");
    capacity_ = slots;
}

void MarkTexture::setPage(std::uint32_t place, std::uint32_t page) {
    words_.write(std::as_bytes(std::span(&page, 1)), place);
}

std::map<std::uint32_t, MarkTexture::Words> MarkTexture::changes(const Marks& marks) const {
    std::set<std::uint32_t> places;
    for (const std::uint32_t changed : changedBricks(*shown_, marks)) {
        addPlacesOf(marks.grid(), changed, places);
    }
    std::map<std::uint32_t, Words> found;
    for (const std::uint32_t place : places) {
        Words words = wordsOf(around(marks, marks.grid().brickAt(place)));
        if (!haveCoverage(words)) {
            words.clear();
        }
        if (!words.empty() || slots_.count(place) > 0) {
            found[place] = std::move(words);
        }
    }
    return found;
}

void MarkTexture::place(std::uint32_t place, const Words& words) {
    const auto known = slots_.find(place);
    std::uint32_t slot = 0;
    if (known != slots_.end()) {
        slot = known->second;
    } else if (!free_.empty()) {
        slot = free_.back();
        free_.pop_back();
    } else {
        slot = used_++;
    }
    words_.write(std::as_bytes(std::span(words)), pagesOf(grid_) + slot * kSlotWords);
    if (known == slots_.end()) {
        slots_[place] = slot;
        setPage(place, slot + 1);
    }
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
    auto changed = changes(*marks);
    const auto slotsFor = [&] { // what there is then
        std::size_t slots = slots_.size();
        for (const auto& [place, words] : changed) {
            slots += slots_.count(place) == 0 ? 1 : 0;
            slots -= words.empty() ? 1 : 0;
        }
        return slots;
    };
    if (const std::size_t slots = slotsFor(); slots > capacity_) {
        const std::size_t most = mostSlots(grid_);
        if (slots > most) {
            if (!std::exchange(hasComplained_, true)) {
                logNotice(
                    fmt::format("there are marks in {} bricks, and this device has room for {}: they are "
                                "not shown",
                                slots, most));
            }
            forget();
            return;
        }
        begin(grid_, std::min(std::max({slots, 2 * capacity_, kFirstSlots}), most));
        changed = changes(*marks); // all of it has to come again
    }
    for (const auto& [place, words] : changed) {
        if (words.empty()) {
            setPage(place, 0);
            free_.push_back(slots_.at(place));
            slots_.erase(place);
        }
    }
    for (const auto& [place, words] : changed) {
        if (!words.empty()) {
            this->place(place, words);
        }
    }
    shown_ = marks;
}

void MarkTexture::bind(const volume::GridGeometry& geometry) const {
    words_.bindTexture(kMarksTexture);
    if (!block_) {
        block_ = gl::Buffer(sizeof(MarksBlock), "where marks lie");
    }
    const double perStep = geometry.stepMm() / grid_.texelMm(geometry);
    block_.writeValue(MarksBlock{glm::ivec4(grid_.bricks(), int(pagesOf(grid_))),
                                 glm::vec4(glm::vec3(grid_.perVoxel), float(perStep))});
    block_.bindUniform(kMarksBlock);
}

} // namespace vs::field
