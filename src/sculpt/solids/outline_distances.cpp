// SPDX-License-Identifier: Apache-2.0
#include "sculpt/solids/solid_cut.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

double squaredDistance(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double squared = glm::dot(ab, ab);
    const double s = squared > 0 ? std::clamp(glm::dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec2 away = p - (a + s * ab);
    return glm::dot(away, away);
}

// Lowers the raster's squared distances to those from one edge, within the band around it.
void paintEdge(OutlineDistances& raster, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 lo = glm::min(a, b) - raster.band - raster.origin;
    const glm::dvec2 hi = glm::max(a, b) + raster.band - raster.origin;
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(lo)), glm::ivec2(0));
    const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(hi)), raster.size - 1);
    for (int y = first.y; y <= last.y; ++y) {
        float* row = &raster.values[std::size_t(y) * std::size_t(raster.size.x)];
        for (int x = first.x; x <= last.x; ++x) {
            row[x] = std::min(row[x], float(squaredDistance(raster.origin + glm::dvec2(x, y), a, b)));
        }
    }
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
    for (std::size_t n = 0; n < outline.size(); ++n) {
        paintEdge(raster, outline[n], outline[(n + 1) % outline.size()]);
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
