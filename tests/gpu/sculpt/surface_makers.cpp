// SPDX-License-Identifier: Apache-2.0
#include "surface_makers.h"

namespace vs::test {

std::vector<field::SurfacePoint>
surfaceUnder(const sculpt::MaskRaster& mask,
             const std::function<std::optional<SurfaceHit>(glm::dvec2)>& hit) {
    std::vector<field::SurfacePoint> points;
    for (int j = 0; j < mask.size.y; ++j) {
        for (int i = 0; i < mask.size.x; ++i) {
            field::SurfacePoint point;
            if (const auto found = hit(mask.origin + mask.pitch * glm::dvec2(i, j))) {
                point.voxel = glm::vec4(glm::vec3(found->voxel), 1);
                point.normal = glm::vec4(glm::vec3(found->normal), 0);
            }
            points.push_back(point);
        }
    }
    return points;
}

std::vector<field::SurfacePoint> slabUnder(const sculpt::MaskRaster& mask, double height) {
    return surfaceUnder(mask, [&](glm::dvec2 e) { return SurfaceHit{{e.x, e.y, height}, {0, 0, -1}}; });
}

std::vector<field::SurfacePoint> sphereUnder(const sculpt::MaskRaster& mask, glm::dvec3 centre,
                                             double radius) {
    return surfaceUnder(mask, [&](glm::dvec2 e) -> std::optional<SurfaceHit> {
        const glm::dvec2 off = e - glm::dvec2(centre);
        const double squared = radius * radius - glm::dot(off, off);
        if (squared < 0) {
            return std::nullopt;
        }
        const glm::dvec3 normal(off / radius, -std::sqrt(squared) / radius);
        return SurfaceHit{centre + radius * normal, normal};
    });
}

std::vector<field::SurfacePoint> hollowSphereUnder(const sculpt::MaskRaster& mask, glm::dvec3 centre,
                                                   double radius) {
    return surfaceUnder(mask, [&](glm::dvec2 e) {
        const glm::dvec3 way = glm::normalize(glm::dvec3(e, 1));
        return SurfaceHit{centre + radius * way, -way};
    });
}

float sampleGrid(const std::vector<float>& values, glm::ivec3 dims, glm::dvec3 p) {
    const glm::dvec3 base = glm::floor(p);
    const glm::dvec3 f = p - base;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 c(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(c));
        const glm::ivec3 v = glm::clamp(glm::ivec3(base) + c, glm::ivec3(0), dims - 1);
        sum += w.x * w.y * w.z *
               values[(std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
                      std::size_t(v.x)];
    }
    return float(sum);
}

double crossingOf(const std::vector<float>& values, glm::ivec3 dims, glm::dvec3 from, glm::dvec3 way,
                  double reach) {
    double lo = 0;
    double hi = reach;
    for (int n = 0; n < 40; ++n) {
        const double mid = 0.5 * (lo + hi);
        (sampleGrid(values, dims, from + mid * way) >= 0.5F ? lo : hi) = mid;
    }
    return 0.5 * (lo + hi);
}

} // namespace vs::test
