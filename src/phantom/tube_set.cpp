// SPDX-License-Identifier: Apache-2.0
#include "phantom/tube_set.h"

#include "phantom/solid_distances.h"

#include <cmath>

namespace vs::phantom {

namespace {

constexpr double kTileMm = 6;
constexpr double kPieceMm = 1.5; // of a smooth tube, at most

glm::dvec4 catmullRom(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c, const glm::dvec4& d,
                      double t) {
    return 0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                  t * t * t * (3.0 * b - a - 3.0 * c + d));
}

glm::dvec4 packed(const TubePoint& point) { return {point.place, point.radius}; }

} // namespace

std::vector<TubePoint> smoothTube(std::span<const TubePoint> through) {
    std::vector<TubePoint> tube{through.front()};
    const auto at = [&](std::ptrdiff_t i) {
        const auto last = std::ptrdiff_t(through.size()) - 1;
        if (i < 0) {
            return 2.0 * packed(through[0]) - packed(through[1]);
        }
        return i <= last ? packed(through[std::size_t(i)])
                         : 2.0 * packed(through[std::size_t(last)]) - packed(through[std::size_t(last - 1)]);
    };
    for (std::ptrdiff_t i = 0; i + 1 < std::ptrdiff_t(through.size()); ++i) {
        const glm::dvec4 from = at(i);
        const glm::dvec4 to = at(i + 1);
        const int pieces = std::max(1, int(std::ceil(glm::length(glm::dvec3(to - from)) / kPieceMm)));
        for (int k = 1; k <= pieces; ++k) {
            const glm::dvec4 place = catmullRom(at(i - 1), from, to, at(i + 2), double(k) / pieces);
            const double least = std::min(from.w, to.w); // splines overshoot
            tube.push_back({glm::dvec3(place), std::max(place.w, least)});
        }
    }
    return tube;
}

double TubeSet::Cone::share(glm::dvec3 p) const {
    return std::clamp(glm::dot(p - from, axis) / (lengthMm * lengthMm), 0.0, 1.0);
}

int TubeSet::add(std::span<const TubePoint> places) {
    double along = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const glm::dvec3 axis = places[i + 1].place - places[i].place;
        const double length = glm::length(axis);
        if (length > 0) {
            cones_.push_back(
                {places[i].place, axis, length, places[i].radius, places[i + 1].radius, along, tubeCount_});
        }
        along += length;
    }
    return tubeCount_++;
}

glm::ivec3 TubeSet::tileOf(glm::dvec3 p) const { return glm::floor((p - corner_) / kTileMm); }

Box3 TubeSet::tilesNear(const Cone& cone) const {
    const glm::dvec3 margin(std::max(cone.radiusFrom, cone.radiusTo) + reachMm_);
    const glm::dvec3 to = cone.from + cone.axis;
    return {tileOf(glm::min(cone.from, to) - margin), tileOf(glm::max(cone.from, to) + margin) + 1};
}

template <typename Visit>
void TubeSet::forEachTileNear(const Cone& cone, const Visit& visit) const {
    const double far = 0.5 * std::sqrt(3.0) * kTileMm + reachMm_; // from a tile's middle
    forEachVoxel(tilesNear(cone), [&](glm::ivec3 tile, std::size_t) {
        const glm::dvec3 middle = corner_ + kTileMm * (glm::dvec3(tile) + 0.5);
        if (coneDistance(middle, cone.from, cone.radiusFrom, cone.from + cone.axis, cone.radiusTo) < far) {
            visit(std::size_t(tile.x + tiles_.x * (tile.y + tiles_.y * tile.z)));
        }
    });
}

void TubeSet::finish() {
    Box3 box;
    for (const Cone& cone : cones_) {
        box = unite(box, tilesNear(cone)); // around the origin so far
    }
    corner_ = kTileMm * glm::dvec3(box.lo);
    tiles_ = box.size();
    begins_.assign(box.volume() + 1, 0);
    for (const Cone& cone : cones_) {
        forEachTileNear(cone, [&](std::size_t tile) { ++begins_[tile + 1]; });
    }
    for (std::size_t i = 1; i < begins_.size(); ++i) {
        begins_[i] += begins_[i - 1];
    }
    sorted_.resize(begins_.back());
    auto next = begins_;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
        forEachTileNear(cones_[i], [&](std::size_t tile) { sorted_[next[tile]++] = std::uint32_t(i); });
    }
}

TubeSet::Nearest TubeSet::nearest(glm::dvec3 p) const {
    Nearest all;
    all.distance = reachMm_;
    const glm::ivec3 tile = tileOf(p);
    if (glm::any(glm::lessThan(tile, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(tile, tiles_))) {
        return all;
    }
    double blended = reachMm_;
    Nearest one = all; // the closest place of the tube that is looked at
    const auto endTube = [&] {
        const double blend = std::min({blendMm_, one.radius, all.tube < 0 ? blendMm_ : all.radius});
        blended = all.tube < 0 ? one.distance : smoothMin(blended, one.distance, std::max(blend, 1e-6));
        all = one.distance < all.distance ? one : all;
    };
    const std::size_t number = std::size_t(tile.x + tiles_.x * (tile.y + tiles_.y * tile.z));
    for (std::uint32_t i = begins_[number]; i < begins_[number + 1]; ++i) {
        const Cone& cone = cones_[sorted_[i]];
        if (one.tube != cone.tube) {
            if (one.tube >= 0) {
                endTube();
            }
            one = {.distance = 1e9, .tube = cone.tube};
        }
        const double t = cone.share(p);
        const double radius = glm::mix(cone.radiusFrom, cone.radiusTo, t);
        const glm::dvec3 middle = cone.from + t * cone.axis;
        const double distance = glm::length(p - middle) - radius;
        if (distance < one.distance) {
            one = {distance,  radius, cone.alongMm + t * cone.lengthMm,
                   cone.tube, middle, cone.axis / cone.lengthMm};
        }
    }
    if (one.tube >= 0) {
        endTube();
    }
    all.distance = std::min(blended, reachMm_);
    return all;
}

} // namespace vs::phantom
