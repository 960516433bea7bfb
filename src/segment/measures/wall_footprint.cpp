// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/wall_footprint.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {

Footprint footprintAt(const Lumen& lumen, const Station& station, const Sight& sight) {
    glm::dmat3 edges(lumen.worldFromVoxel);
    edges[lumen.coarseAxis()] *= sight.thickness;
    const auto inPlane = [&](const glm::dvec3& v) {
        return glm::dvec2(glm::dot(v, station.across), glm::dot(v, station.up));
    };
    Footprint footprint;
    footprint.covariance = glm::dmat2(sight.blurMm * sight.blurMm);
    glm::ivec3 counts(1);
    for (int axis = 0; axis < 3; ++axis) {
        const double steps = glm::length(edges[axis]) / lumen.stepMm;
        const int most = int(Footprint::kMostPlaces) / (counts.x * counts.y * counts.z);
        counts[axis] = std::clamp(int(std::lround(steps)), 1, std::min(most, 4));
        const glm::dvec2 edge = inPlane(edges[axis]) / double(counts[axis]);
        footprint.covariance += glm::outerProduct(edge, edge) / 12.0;
    }
    forEachVoxel({glm::ivec3(0), counts}, [&](glm::ivec3 at, std::size_t) {
        const glm::dvec3 offset = (glm::dvec3(at) + 0.5) / glm::dvec3(counts) - 0.5;
        footprint.places[footprint.count++] = inPlane(edges * offset);
    });
    return footprint;
}

WallParts::WallParts(const Footprint& footprint, const WallVoxel& voxel) : count_(footprint.count) {
    const glm::dvec2 centre = voxel.radiusMm * glm::dvec2(voxel.cosine, voxel.sine);
    // Four places that have the covariance (its Cholesky factor's columns, there and back).
    const glm::dmat2& c = footprint.covariance;
    const double l = std::sqrt(c[0][0]);
    const glm::dvec2 first = std::sqrt(2.0) * glm::dvec2(l, c[0][1] / l);
    const glm::dvec2 second(0, std::sqrt(2 * std::max(0.0, c[1][1] - c[0][1] * c[0][1] / c[0][0])));
    for (std::size_t i = 0; i < count_; ++i) {
        const glm::dvec2 place = centre + footprint.places[i];
        const std::array<double, 4> radii{glm::length(place + first), glm::length(place - first),
                                          glm::length(place + second), glm::length(place - second)};
        means_[i] = (radii[0] + radii[1] + radii[2] + radii[3]) / 4;
        double variance = 1e-9 * c[0][0];
        for (const double radius : radii) {
            variance += (radius - means_[i]) * (radius - means_[i]) / 4;
        }
        spreads_[i] = std::sqrt(variance);
    }
}

WallParts::Inside WallParts::inside(double wallMm) const {
    Inside inside;
    for (std::size_t i = 0; i < count_; ++i) {
        const double sigmas = (wallMm - means_[i]) / spreads_[i];
        inside.part += 0.5 * std::erfc(-sigmas * glm::one_over_root_two<double>());
        inside.change += std::exp(-0.5 * sigmas * sigmas) / spreads_[i];
    }
    inside.part /= double(count_);
    inside.change /= double(count_) * std::sqrt(glm::two_pi<double>());
    return inside;
}

} // namespace vs::segment
