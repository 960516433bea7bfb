// SPDX-License-Identifier: Apache-2.0
#include "reference/slice_renderer.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vs::reference {

namespace {

double displayed(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

// Of a function of voxels at a place of voxel space.
double sample(const std::function<double(glm::ivec3)>& of, glm::dvec3 p, glm::ivec3 dims, bool isSmooth) {
    const auto at = [&](glm::ivec3 voxel) { return of(glm::clamp(voxel, glm::ivec3(0), dims - 1)); };
    if (!isSmooth) {
        return at(glm::ivec3(glm::floor(p + 0.5)));
    }
    const glm::dvec3 base = glm::floor(p);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - (p - base), p - base, offset);
        sum += w.x * w.y * w.z * at(glm::ivec3(base + offset));
    }
    return sum;
}

} // namespace

image::Image drawSlice(const SliceScene& scene, const render::SliceView& view) {
    const auto& grid = scene.volume->geometry;
    const render::SliceGeometry geometry(grid, view.kind);
    image::Image image(view.size.x, view.size.y);
    const auto indexOf = [&](glm::ivec3 v) {
        return (std::size_t(v.z) * std::size_t(grid.dims.y) + std::size_t(v.y)) * std::size_t(grid.dims.x) +
               std::size_t(v.x);
    };
    for (int y = 0; y < view.size.y; ++y) {
        for (int x = 0; x < view.size.x; ++x) {
            const glm::dvec3 p = geometry.voxelAt(view.placeAt({x + 0.5, y + 0.5}), view.index);
            glm::dvec3 colour(0.043, 0.051, 0.059);
            if (glm::all(glm::greaterThanEqual(p, glm::dvec3(-0.5))) &&
                glm::all(glm::lessThan(p, glm::dvec3(grid.dims) - 0.5))) {
                const double value =
                    sample([&](glm::ivec3 v) { return scene.volume->at(v); }, p, grid.dims, scene.isSmooth);
                colour = glm::dvec3(std::clamp((value - scene.window.lo) / scene.window.width(), 0.0, 1.0));
                for (int label = 1; label < 256 && !scene.membership.empty(); ++label) {
                    const auto belongs = [&](glm::ivec3 v) {
                        const float membership = scene.membership[indexOf(v)];
                        const bool isAnothers =
                            membership >= 0.5F && scene.labels[indexOf(v)] != std::uint8_t(label);
                        return isAnothers ? 0.0 : double(membership);
                    };
                    const bool isIn = sample(belongs, p, grid.dims, scene.isSmooth) >= 0.5;
                    const glm::vec4 entry = scene.colours.entries[std::size_t(label)];
                    for (int c = 0; isIn && c < 3; ++c) {
                        colour[c] = glm::mix(colour[c], displayed(double(entry[c])), scene.fill * entry.a);
                    }
                }
            }
            for (int c = 0; c < 3; ++c) {
                image.pixel(x, y)[c] = std::uint8_t(std::lround(255 * colour[c]));
            }
            image.pixel(x, y)[3] = 255;
        }
    }
    return image;
}

} // namespace vs::reference
