// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/apart_tiles.h"

#include "base/error.h"
#include "field/shaders/apart_tiles.h"

#include <algorithm>
#include <cmath>

namespace vs::segment {

namespace {

using field::kApartPadded;

constexpr int kMostAlong = 120; // times 17 is what every device has room for along an axis

// Tiles side by side in a layer of the texture, so that a layer is small and yet all of them have room for
// the grid's fifteen times or more; of a small grid once for each label.
int placesAlong(glm::ivec3 tileDims) {
    constexpr int kMostLabels = 255;
    constexpr double kSmallLayer = 16;
    const double tiles = double(tileDims.x) * tileDims.y * tileDims.z;
    const double forAllLabels = std::sqrt(tiles * kMostLabels / kMostAlong);
    const double along = std::max(2 * std::cbrt(tiles), std::min(forAllLabels, kSmallLayer));
    return std::min(int(std::ceil(along)), kMostAlong);
}

std::uint32_t asPage(glm::ivec3 place) {
    return std::uint32_t(field::kPageIsStored) |
           (std::uint32_t(place.x) | std::uint32_t(place.y) << 8 | std::uint32_t(place.z) << 16)
               << field::kPagePlaceShift;
}

constexpr std::uint32_t kPlaceBits = std::uint32_t(0xffffff) << field::kPagePlaceShift | field::kPageIsStored;

} // namespace

ApartTiles::ApartTiles(glm::ivec3 tileDims)
    : tileDims_(tileDims), places_(placesAlong(tileDims), placesAlong(tileDims), 0) {}

void ApartTiles::keep(std::span<const std::uint8_t> labels) {
    std::erase_if(segments_, [&](const auto& entry) {
        const bool isGone = std::find(labels.begin(), labels.end(), entry.first) == labels.end();
        if (isGone) {
            giveBack(entry.second);
        }
        return isGone;
    });
    const std::size_t tiles = std::size_t(tileDims_.x) * std::size_t(tileDims_.y) * std::size_t(tileDims_.z);
    for (const std::uint8_t label : labels) {
        if (!segments_.contains(label)) {
            segments_.emplace(label, Segment{std::vector<Whose>(tiles, Whose::Nobodys),
                                             std::vector<std::uint32_t>(tiles, 0),
                                             gl::Texture(tileDims_, gl::Format::R32UI, gl::Filter::Nearest,
                                                         "pages of a segment alone")});
        }
    }
}

std::vector<std::uint8_t> ApartTiles::labels() const {
    std::vector<std::uint8_t> labels;
    for (const auto& [label, segment] : segments_) {
        labels.push_back(label);
    }
    return labels;
}

bool ApartTiles::hasNew() const {
    return std::any_of(segments_.begin(), segments_.end(),
                       [](const auto& entry) { return entry.second.isNew; });
}

void ApartTiles::renewAll() {
    for (auto& [label, segment] : segments_) {
        segment.isNew = true;
    }
}

void ApartTiles::giveBack(const Segment& segment) {
    for (const std::uint32_t page : segment.pages) {
        if ((page & field::kPageIsStored) != 0) {
            free_.push_back(page & kPlaceBits);
        }
    }
}

void ApartTiles::growTo(int layers) {
    const glm::ivec3 places(places_.x, places_.y, layers);
    gl::Texture larger(kApartPadded * places, gl::Format::R8, gl::Filter::Linear, "segments alone");
    if (texels_) {
        larger.copyFrom(texels_, {glm::ivec3(0), texels_.size()}, glm::ivec3(0));
    }
    texels_ = std::move(larger);
    for (int z = layers; z-- > places_.z;) { // the lowest are taken first
        for (int y = places.y; y-- > 0;) {
            for (int x = places.x; x-- > 0;) {
                free_.push_back(asPage({x, y, z}));
            }
        }
    }
    places_ = places;
}

std::uint32_t ApartTiles::takePlace() {
    if (free_.empty()) {
        if (places_.z == kMostAlong) {
            throw Error(
                "the segments that are pulled out touch others in more than {} places; put some back, "
                "or hide segments",
                places_.x * places_.y * places_.z);
        }
        growTo(std::min(std::max(places_.z + 1, places_.z * 3 / 2), kMostAlong));
    }
    const std::uint32_t page = free_.back();
    free_.pop_back();
    return page;
}

// By the tile and those after it along each axis, into which its last voxels' interpolation reaches.
std::uint32_t ApartTiles::pageOf(const Segment& segment, std::uint32_t tile) {
    const int i = int(tile);
    const glm::ivec3 at(i % tileDims_.x, i / tileDims_.x % tileDims_.y, i / (tileDims_.x * tileDims_.y));
    bool isBesideOthers = false;
    bool isAlone = false;
    bool isOthers = false;
    for (int n = 0; n < 8; ++n) {
        const glm::ivec3 there = at + glm::ivec3(n & 1, n >> 1 & 1, n >> 2);
        if (glm::all(glm::lessThan(there, tileDims_))) {
            const Whose whose =
                segment.whose[std::size_t((there.z * tileDims_.y + there.y) * tileDims_.x + there.x)];
            isBesideOthers = isBesideOthers || whose == Whose::BesideOthers;
            isAlone = isAlone || whose == Whose::Alone;
            isOthers = isOthers || whose == Whose::Others;
        }
    }
    const Whose own = segment.whose[tile];
    std::uint32_t page = own == Whose::BesideOthers ? std::uint32_t(field::kBesideOthers)
                         : own == Whose::Others     ? std::uint32_t(field::kNothingOfIt)
                                                    : std::uint32_t(field::kSharedWithNone);
    if (isBesideOthers || (isAlone && isOthers)) {
        const std::uint32_t before = segment.pages[tile];
        page |= (before & field::kPageIsStored) != 0 ? before & kPlaceBits : takePlace();
    } else if (!isOthers) {
        page |= std::uint32_t(field::kPageIsShared);
    }
    return page;
}

ApartTiles::Changes ApartTiles::place(std::uint8_t label, std::span<const std::uint32_t> tiles,
                                      std::span<const Whose> whose) {
    Segment& segment = segments_.at(label);
    std::vector<std::uint32_t> affected;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        segment.whose[tiles[i]] = whose[i];
        const int tile = int(tiles[i]);
        const glm::ivec3 at(tile % tileDims_.x, tile / tileDims_.x % tileDims_.y,
                            tile / (tileDims_.x * tileDims_.y));
        for (int n = 0; n < 8; ++n) {
            const glm::ivec3 there = at - glm::ivec3(n & 1, n >> 1 & 1, n >> 2);
            if (glm::all(glm::greaterThanEqual(there, glm::ivec3(0)))) {
                affected.push_back(std::uint32_t((there.z * tileDims_.y + there.y) * tileDims_.x + there.x));
            }
        }
    }
    std::sort(affected.begin(), affected.end());
    affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
    Changes changes;
    for (const std::uint32_t tile : affected) {
        const std::uint32_t page = pageOf(segment, tile);
        const bool isStored = (page & field::kPageIsStored) != 0;
        if (!isStored && (segment.pages[tile] & field::kPageIsStored) != 0) {
            free_.push_back(segment.pages[tile] & kPlaceBits);
        }
        segment.pages[tile] = page;
        if (isStored) {
            changes.incomplete.push_back(tile);
        }
    }
    for (const std::uint32_t tile : tiles) {
        if (segment.whose[tile] == Whose::BesideOthers) {
            changes.own.push_back(tile);
            changes.pagesOfOwn.push_back(segment.pages[tile]);
        }
    }
    segment.texture.upload({glm::ivec3(0), tileDims_}, std::as_bytes(std::span(segment.pages)));
    segment.isNew = false;
    return changes;
}

std::size_t ApartTiles::deviceBytes() const {
    const auto bytesOf = [](const gl::Texture& texture) {
        const glm::i64vec3 size(texture.size());
        return texture ? std::size_t(size.x * size.y * size.z) * gl::bytesPerTexel(texture.format()) : 0;
    };
    std::size_t bytes = bytesOf(texels_);
    for (const auto& [label, segment] : segments_) {
        bytes += bytesOf(segment.texture);
    }
    return bytes;
}

} // namespace vs::segment
