// SPDX-License-Identifier: Apache-2.0
#include "field/fill/fill_texture.h"

#include "base/log.h"
#include "field/shaders/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vs::field {

namespace {

// As fill.glsl has it: for each cell of a brick, and once more along z, how much its four corners with the
// lesser z are filled, two a word; and then their materials, four a word.
constexpr std::size_t kCells = std::size_t(kFillBrick) * kFillBrick * FillCorners::kSide;
constexpr std::size_t kWords = 3 * kCells;

std::size_t placesOf(const Fill& fill) {
    const glm::ivec3 n = fill.brickDims();
    return std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z);
}

BrickWords::Words wordsOf(const FillCorners& corners) {
    constexpr std::size_t side = FillCorners::kSide;
    BrickWords::Words words(kWords);
    const auto& f = corners.filled;
    const auto& m = corners.material;
    forEachVoxel({glm::ivec3(0), glm::ivec3(kFillBrick, kFillBrick, FillCorners::kSide)}, [&](glm::ivec3 t,
                                                                                              std::size_t i) {
        const std::size_t at = (std::size_t(t.z) * side + std::size_t(t.y)) * side + std::size_t(t.x);
        words[2 * i] = std::uint32_t(f[at]) | std::uint32_t(f[at + 1]) << 16;
        words[2 * i + 1] = std::uint32_t(f[at + side]) | std::uint32_t(f[at + side + 1]) << 16;
        words[2 * kCells + i] = std::uint32_t(m[at]) | std::uint32_t(m[at + 1]) << 8 |
                                std::uint32_t(m[at + side]) << 16 | std::uint32_t(m[at + side + 1]) << 24;
    });
    return words;
}

BrickWords::Content contentOf(const FillCorners& corners) {
    if (corners.isEmpty) {
        return {};
    }
    if (corners.whole != 0) {
        return {{}, BrickWords::kNoBrick | corners.whole};
    }
    return {wordsOf(corners)};
}

} // namespace

FillTexture::FillTexture() : words_(kWords, "fill") {}

bool FillTexture::hasRoomFor(const Fill& fill) {
    const std::size_t most = BrickWords::mostBricks(placesOf(fill), kWords);
    if (8 * fill.bricks().entries().size() <= most) {
        return true;
    }
    const auto places = placesWithOtherCorners(Fill(), fill);
    return std::size_t(std::count_if(places.begin(), places.end(), [&](std::uint32_t place) {
               const FillCorners corners = cornersOf(fill, place);
               return !corners.isEmpty && corners.whole == 0;
           })) <= most;
}

BrickWords::Changes FillTexture::changes(const Fill& before, const Fill& fill) const {
    BrickWords::Changes found;
    for (const std::uint32_t place : placesWithOtherCorners(before, fill)) {
        BrickWords::Content content = contentOf(cornersOf(fill, place));
        if (!content.words.empty() || content.page != 0 || words_.isHeld(place)) {
            found[place] = std::move(content);
        }
    }
    return found;
}

void FillTexture::show(const SharedFill& fill) {
    if (shown_ == fill) {
        return;
    }
    if (fill->isEmpty()) {
        words_.forget();
        shown_ = fill;
        return;
    }
    std::size_t tooMany = 0;
    try {
        tooMany = words_.update(placesOf(*fill),
                                [&](bool isAll) { return changes(isAll ? Fill() : *shown_, *fill); });
    } catch (...) { // half of it is there
        words_.forget();
        shown_ = std::make_shared<const Fill>();
        throw;
    }
    if (tooMany > 0) {
        if (!std::exchange(hasComplained_, true)) {
            logNotice(fmt::format("material lies in {} bricks, and this device has room for {}: it is not "
                                  "shown",
                                  tooMany, BrickWords::mostBricks(placesOf(*fill), kWords)));
        }
        words_.forget();
        shown_ = std::make_shared<const Fill>();
        return;
    }
    shown_ = fill;
}

void FillTexture::bind(const ShownMaterials& materials) const {
    words_.bindTexture(kFillTexture);
    if (!block_) {
        block_ = gl::Buffer(sizeof(FillBlock), "materials");
    }
    FillBlock block;
    block.fillBricks = glm::ivec4(shown_->brickDims(), int(words_.firstWord()));
    for (std::size_t n = 0; n < materials.size() && n < kMostMaterials; ++n) {
        block.materials[n + 1] = glm::vec4(materials[n].colour, materials[n].value);
        block.fillSeen.x |= materials[n].isSeen ? std::uint32_t(2) << n : 0;
    }
    block_.writeValue(block);
    block_.bindUniform(kFillBlock);
}

bool areAllSeen(const ShownMaterials& materials) {
    return std::all_of(materials.begin(), materials.end(), [](const ShownMaterial& m) { return m.isSeen; });
}

} // namespace vs::field
