// SPDX-License-Identifier: Apache-2.0
#include "field/marks/mark_texture.h"

#include "base/error.h"
#include "field/shaders/bindings.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>

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
    const std::size_t most = gl::TexelBuffer::mostTexels();
    return most > pagesOf(grid) ? (most - pagesOf(grid)) / kSlotWords : 0;
}

bool haveCoverage(const std::vector<std::uint32_t>& words) {
    return std::any_of(words.begin() + std::ptrdiff_t(kColourWords), words.end(),
                       [](std::uint32_t word) { return word != 0; });
}

} // namespace

std::size_t MarkTexture::mostBricks(const MarkGrid& grid) { return mostSlots(grid) / 2; }

void MarkTexture::begin(const MarkGrid& grid) {
    grid_ = grid;
    pages_.assign(pagesOf(grid), 0);
    slots_.clear();
    free_.clear();
    used_ = 0;
    capacity_ = 0;
    shown_ = std::make_shared<const Marks>();
}

void MarkTexture::makeRoom(std::size_t slots) {
    if (slots <= capacity_) {
        return;
    }
    const std::size_t most = mostSlots(grid_);
    if (slots > most) {
        throw Error("there are marks in {} bricks; this device holds {}: undo some, or erase some", slots,
                    most);
    }
    const std::size_t capacity = std::min(std::max({slots, 2 * capacity_, kFirstSlots}), most);
    begin(grid_); // all of it has to come again
    words_ = gl::TexelBuffer();
    words_ = gl::TexelBuffer(pages_.size() + capacity * kSlotWords, gl::Format::R32UI, "marks");
    if (!block_) {
        block_ = gl::Buffer(sizeof(MarksBlock), "where marks lie");
    }
    block_.writeValue(
        MarksBlock{glm::ivec4(grid_.bricks(), int(pages_.size())), glm::vec4(glm::vec3(grid_.perVoxel), 0)});
    capacity_ = capacity;
}

void MarkTexture::setPage(std::uint32_t place, std::uint32_t page) {
    pages_[place] = page;
    words_.write(std::as_bytes(std::span(&page, 1)), place);
}

void MarkTexture::place(const Marks& marks, std::uint32_t place) {
    const auto words = wordsOf(around(marks, grid_.brickAt(place)));
    const auto known = slots_.find(place);
    if (!haveCoverage(words)) {
        if (known != slots_.end()) {
            setPage(place, 0);
            free_.push_back(known->second);
            slots_.erase(known);
        }
        return;
    }
    std::uint32_t slot = 0;
    if (known != slots_.end()) {
        slot = known->second;
    } else if (!free_.empty()) {
        slot = free_.back();
        free_.pop_back();
    } else {
        slot = used_++;
    }
    words_.write(std::as_bytes(std::span(words)), pages_.size() + slot * kSlotWords);
    if (known == slots_.end()) {
        slots_[place] = slot;
        setPage(place, slot + 1);
    }
}

void MarkTexture::show(const SharedMarks& marks) {
    if (shown_ == marks || (marks->isEmpty() && isEmpty())) {
        shown_ = marks;
        return;
    }
    if (!marks->isEmpty() && (!words_ || !(grid_ == marks->grid()))) {
        begin(marks->grid());
    }
    // Bricks also appear in those before them.
    const auto touched = [&] {
        std::set<std::uint32_t> places;
        for (const std::uint32_t changed : changedBricks(*shown_, *marks)) {
            const glm::ivec3 brick = grid_.brickAt(changed);
            for (int i = 0; i < 8; ++i) {
                const glm::ivec3 there = brick - glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
                if (glm::all(glm::greaterThanEqual(there, glm::ivec3(0)))) {
                    places.insert(grid_.placeOf(there));
                }
            }
        }
        return places;
    };
    auto places = touched();
    if (slots_.size() + places.size() > capacity_) {
        const SharedMarks before = shown_;
        makeRoom(slots_.size() + places.size());
        places = shown_ != before ? touched() : places;
    }
    const SharedMarks nothing = std::make_shared<const Marks>(Marks(grid_, {}));
    const Marks& shown = marks->isEmpty() ? *nothing : *marks;
    for (const std::uint32_t p : places) {
        place(shown, p);
    }
    shown_ = marks;
}

void MarkTexture::bind() const {
    words_.bindTexture(kMarksTexture);
    block_.bindUniform(kMarksBlock);
}

} // namespace vs::field
