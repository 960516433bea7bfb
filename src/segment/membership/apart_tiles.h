// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texture.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace vs::segment {

// Memberships of certain segments alone, for where others touch them: tiles of 16^3 voxels of all those
// segments in one texture, and for each segment a page for each tile of the grid
// (field/shaders/apart_tiles.glsl). Knows where tiles lie, not what is in them. Where a segment meets no
// other it takes no more than its pages.
class ApartTiles {
public:
    // Whose a tile's voxels, and those that smoothing carries into it, are.
    enum class Whose : std::uint8_t { Nobodys, Others, Alone, BesideOthers };

    explicit ApartTiles(glm::ivec3 tileDims);

    // Keeps these segments, by label, and forgets all others. What is new has to be placed everywhere.
    void keep(std::span<const std::uint8_t> labels);
    [[nodiscard]] std::vector<std::uint8_t> labels() const;
    [[nodiscard]] bool isNew(std::uint8_t label) const { return segments_.at(label).isNew; }
    [[nodiscard]] bool hasNew() const;
    [[nodiscard]] Whose whose(std::uint8_t label, std::uint32_t tile) const {
        return segments_.at(label).whose[tile];
    }
    void renewAll();

    // What has to be written after place(): tiles by their numbers, and where they lie, as pages say it.
    struct Changes {
        std::vector<std::uint32_t> own; // its own voxels, beside others'
        std::vector<std::uint32_t> pagesOfOwn;
        std::vector<std::uint32_t> incomplete; // all else in these: after that
    };
    // Says anew whose these tiles are, as one segment sees it. Throws GlError when the device has no room,
    // and Error when there are more tiles than a texture has places for.
    Changes place(std::uint8_t label, std::span<const std::uint32_t> tiles, std::span<const Whose> whose);

    [[nodiscard]] const gl::Texture& texels() const { return texels_; }
    [[nodiscard]] gl::Texture& texels() { return texels_; }
    [[nodiscard]] const gl::Texture& pages(std::uint8_t label) const { return segments_.at(label).texture; }
    [[nodiscard]] std::size_t deviceBytes() const;

private:
    struct Segment {
        std::vector<Whose> whose; // by tile
        std::vector<std::uint32_t> pages;
        gl::Texture texture; // the pages, for shaders
        bool isNew = true;
    };
    [[nodiscard]] std::uint32_t pageOf(const Segment& segment, std::uint32_t tile);
    std::uint32_t takePlace();
    void growTo(int layers);
    void giveBack(const Segment& segment);

    glm::ivec3 tileDims_;
    std::map<std::uint8_t, Segment> segments_;
    gl::Texture texels_; // made with the first place that is taken
    glm::ivec3 places_;  // that it has room for
    std::vector<std::uint32_t> free_;
};

} // namespace vs::segment
