// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/surface_raster.h"

#include "sculpt/mask/raster_blur.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr double kMinPeak = 0.6;        // thin masks are raised until their radiation reaches this somewhere
constexpr double kSmallestGapSteps = 3; // neighbours closer than this always belong together
constexpr double kGapElements = 4;      // ... and those closer than this many elements

} // namespace

SurfaceRaster::SurfaceRaster(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                             const volume::GridGeometry& geometry, const ToolSweep& sweep)
    : points_(points), mask_(mask), sweep_(sweep), size_(mask.size),
      stepsFromVoxel_(glm::mat3(geometry.worldFromVoxel) / float(geometry.stepMm())),
      voxelFromSteps_(glm::inverse(stepsFromVoxel_)) {}

void SurfaceRaster::findDirections() {
    chooseDirections();
    measureSpacing();
    if (sweep_.directions.empty() && sweep_.direction == ToolDirection::OwnNormal) {
        smoothDirections();
    }
}

bool SurfaceRaster::anyHitUnderMask() const {
    for (std::size_t n = 0; n < points_.size(); ++n) {
        if (maskAt(n) > 0) {
            return true;
        }
    }
    return false;
}

void SurfaceRaster::chooseDirections() {
    if (!sweep_.directions.empty()) {
        directions_.assign(sweep_.directions.begin(), sweep_.directions.end());
        return;
    }
    const glm::vec3 common(glm::normalize(sweep_.directionWorld));
    directions_.resize(points_.size());
    for (std::size_t n = 0; n < points_.size(); ++n) {
        directions_[n] = sweep_.direction == ToolDirection::Common ? common : -glm::vec3(points_[n].normal);
    }
}

void SurfaceRaster::measureSpacing() {
    std::vector<float> distances;
    const int stride = std::max(1, int(std::sqrt(double(points_.size()) / 2000)));
    for (int j = 0; j < size_.y; j += stride) {
        for (int i = 0; i < size_.x; i += stride) {
            for (const glm::ivec2 next : {glm::ivec2(i + 1, j), glm::ivec2(i, j + 1)}) {
                if (isHit(i, j) && isHit(next.x, next.y)) {
                    const glm::vec3 between = inSteps(place(next.x, next.y) - place(i, j));
                    const float along = glm::dot(between, directions_[at(i, j)]);
                    distances.push_back(
                        std::sqrt(std::max(glm::dot(between, between) - along * along, 0.0F)));
                }
            }
        }
    }
    if (!distances.empty()) {
        const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        spacing_ = std::max(double(*middle), 1e-3);
    }
    gap_ = float(std::max(kGapElements * spacing_, kSmallestGapSteps));
}

void SurfaceRaster::smoothDirections() {
    const auto filled =
        std::count_if(mask_.values.begin(), mask_.values.end(), [](float m) { return m >= 0.5F; });
    const double sigma = std::clamp(std::sqrt(double(filled)) / 8, 1.5 / spacing_, 8.0 / spacing_);
    std::vector<glm::vec3> smooth(directions_.size(), glm::vec3(0));
    for (std::size_t n = 0; n < smooth.size(); ++n) {
        if (points_[n].voxel.w > 0.5F) {
            smooth[n] = directions_[n];
        }
    }
    blurRaster(smooth, size_, sigma);
    for (std::size_t n = 0; n < smooth.size(); ++n) {
        const float length = glm::length(smooth[n]);
        if (length > 1e-6F && glm::dot(smooth[n], directions_[n]) > 0) {
            directions_[n] = smooth[n] / length;
        }
    }
}

float SurfaceRaster::thinMaskGain() const {
    std::vector<float> spread(points_.size());
    for (std::size_t n = 0; n < spread.size(); ++n) {
        spread[n] = maskAt(n);
    }
    blurRaster(spread, size_, sweep_.radius / 3.0 / spacing_);
    const float peak = *std::max_element(spread.begin(), spread.end());
    return peak < kMinPeak && peak > 0 ? float(std::min(kMinPeak / double(peak), 1000.0)) : 1.0F;
}

bool SurfaceRaster::isJoined(glm::ivec2 a, glm::ivec2 b) const {
    if (!isHit(a.x, a.y) || !isHit(b.x, b.y)) {
        return false;
    }
    const glm::vec3 between = inSteps(place(b.x, b.y) - place(a.x, a.y));
    return glm::dot(between, between) <= gap_ * gap_;
}

glm::vec3 SurfaceRaster::meanDirection() const {
    if (sweep_.direction == ToolDirection::Common) {
        return glm::vec3(glm::normalize(sweep_.directionWorld));
    }
    glm::vec3 sum(0);
    for (std::size_t n = 0; n < points_.size(); ++n) {
        sum += isSweptFrom(n) ? directions_[n] : glm::vec3(0);
    }
    return glm::length(sum) > 1e-6F ? glm::normalize(sum) : directions_.front();
}

glm::vec3 SurfaceRaster::meanStep(glm::ivec2 axis) const {
    glm::vec3 sum(0);
    int count = 0;
    for (int j = 0; j + axis.y < size_.y; ++j) {
        for (int i = 0; i + axis.x < size_.x; ++i) {
            if (isJoined({i, j}, glm::ivec2(i, j) + axis)) {
                sum += inSteps(place(i + axis.x, j + axis.y) - place(i, j));
                ++count;
            }
        }
    }
    const glm::vec3 mean = count > 0 ? sum / float(count) : glm::vec3(0);
    const glm::vec3 direction = meanDirection();
    return mean - direction * glm::dot(mean, direction);
}

std::optional<glm::vec3> SurfaceRaster::tangent(glm::ivec2 e, glm::ivec2 axis) const {
    std::optional<glm::vec3> across;
    for (const int side : {1, -1}) {
        const glm::ivec2 next = e + side * axis;
        if (isJoined(e, next)) {
            return float(side) * (place(next.x, next.y) - place(e.x, e.y));
        }
        if (isHit(next.x, next.y) && !across) {
            const glm::vec3 direction = directions_[at(e.x, e.y)];
            const glm::vec3 between = inSteps(place(next.x, next.y) - place(e.x, e.y));
            across = voxelFromSteps_ * (float(side) * (between - direction * glm::dot(between, direction)));
        }
    }
    return across;
}

} // namespace vs::sculpt
