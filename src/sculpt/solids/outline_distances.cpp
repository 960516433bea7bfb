// SPDX-License-Identifier: Apache-2.0
#include "sculpt/solids/solid_cut.h"

#include "base/capsule.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace vs::sculpt {

namespace {

double squaredDistance(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double squared = glm::dot(ab, ab);
    const double s = squared > 0 ? std::clamp(glm::dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec2 away = p - (a + s * ab);
    return glm::dot(away, away);
}

// Squared distances from an outline's edges, within a band around them, in tiles: where an outline scribbles
// about, most edges come nowhere nearer to a tile than others have come already.
class EdgeDistances {
public:
    explicit EdgeDistances(OutlineDistances& raster)
        : raster_(raster), tiles_((raster.size + kTile - 1) / kTile),
          farthest_(std::size_t(tiles_.x) * std::size_t(tiles_.y), raster.band) {}

    void include(glm::dvec2 a, glm::dvec2 b) {
        const double reach = raster_.band + kHalfDiagonal;
        const Capsule<2> around{centre({0, 0}, a), centre({0, 0}, b), reach / kTile};
        const double lo = std::min(around.a.y, around.b.y) - around.radius;
        const double hi = std::max(around.a.y, around.b.y) + around.radius;
        for (int y = within(std::floor(lo), tiles_.y); y < within(std::ceil(hi) + 1, tiles_.y); ++y) {
            if (const auto part = around.onLine({0, y}, {1, 0})) {
                const int end = within(std::ceil(part->hi) + 1, tiles_.x);
                for (int x = within(std::floor(part->lo), tiles_.x); x < end; ++x) {
                    includeIn({x, y}, a, b);
                }
            }
        }
    }

private:
    static constexpr int kTile = 16; // pixels along a side
    static constexpr double kHalfDiagonal = 0.75 * kTile;

    static int within(double place, int size) { return int(std::clamp(place, 0.0, double(size))); }
    // A place as seen from the middle of a tile, in tiles.
    [[nodiscard]] glm::dvec2 centre(glm::ivec2 tile, glm::dvec2 place) const {
        return (place - raster_.origin) / double(kTile) - glm::dvec2(tile) - 0.5 * (kTile - 1.0) / kTile;
    }

    void includeIn(glm::ivec2 tile, glm::dvec2 a, glm::dvec2 b) {
        double& farthest = farthest_[std::size_t(tile.y) * std::size_t(tiles_.x) + std::size_t(tile.x)];
        const double nearest =
            kTile * std::sqrt(squaredDistance(glm::dvec2(0), centre(tile, a), centre(tile, b))) -
            kHalfDiagonal;
        if (nearest > farthest) {
            return;
        }
        const glm::ivec2 first = kTile * tile;
        const glm::ivec2 end = glm::min(first + kTile, raster_.size);
        float most = 0;
        for (int y = first.y; y < end.y; ++y) {
            float* row = &raster_.values[std::size_t(y) * std::size_t(raster_.size.x)];
            for (int x = first.x; x < end.x; ++x) {
                row[x] = std::min(row[x], float(squaredDistance(raster_.origin + glm::dvec2(x, y), a, b)));
                most = std::max(most, row[x]);
            }
        }
        farthest = std::sqrt(double(most)) * (1 + 1e-6);
    }

    OutlineDistances& raster_;
    glm::ivec2 tiles_;
    std::vector<double> farthest_; // that any pixel of a tile is from the outline so far
};

// Each edge once: what was clipped goes to and fro between the corners of its box.
std::vector<std::pair<glm::dvec2, glm::dvec2>> edgesOf(const Outline& outline) {
    const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
        return std::pair(a.x, a.y) < std::pair(b.x, b.y);
    };
    std::vector<std::pair<glm::dvec2, glm::dvec2>> edges;
    for (std::size_t n = 0; n < outline.size(); ++n) {
        edges.push_back(std::minmax(outline[n], outline[(n + 1) % outline.size()], before));
    }
    std::sort(edges.begin(), edges.end(), [&](const auto& one, const auto& other) {
        return one.first != other.first ? before(one.first, other.first) : before(one.second, other.second);
    });
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

} // namespace

OutlineDistances outlineDistances(const Outline& outline, double band) {
    OutlineDistances raster;
    raster.band = band;
    MaskFilter centres;
    centres.sampling = Sampling::None;
    const MaskRaster inside = rasterize(outline, 1, centres);
    if (inside.values.empty()) {
        return raster;
    }
    const int margin = int(std::ceil(band)) + 1;
    raster.origin = inside.origin - double(margin);
    raster.size = inside.size + 2 * margin;
    raster.values.assign(std::size_t(raster.size.x) * std::size_t(raster.size.y), float(band * band));
    EdgeDistances distances(raster);
    for (const auto& [a, b] : edgesOf(outline)) {
        distances.include(a, b);
    }
    for (int y = 0; y < raster.size.y; ++y) {
        for (int x = 0; x < raster.size.x; ++x) {
            float& value = raster.values[std::size_t(y) * std::size_t(raster.size.x) + std::size_t(x)];
            const glm::ivec2 e(x - margin, y - margin);
            const bool isInside = e.x >= 0 && e.y >= 0 && e.x < inside.size.x && e.y < inside.size.y &&
                                  inside.at(e.x, e.y) > 0.5F;
            value = (isInside ? 1.0F : -1.0F) * std::sqrt(value);
        }
    }
    return raster;
}

} // namespace vs::sculpt
