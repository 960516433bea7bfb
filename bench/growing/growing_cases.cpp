// SPDX-License-Identifier: Apache-2.0
#include "growing_cases.h"

#include "base/parallel.h"
#include "phantom/body_phantom.h"
#include "phantom/noise.h"
#include "phantom/phantom.h"
#include "volume/reading/read_volume.h"

#include <fmt/format.h>

#include <cmath>

namespace vs {

namespace {

constexpr std::uint8_t kInside = 100;
constexpr std::uint8_t kSpeckle = 120;
constexpr Range kNarrow{90, 110};
constexpr Range kWide{90, 130};

std::size_t indexIn(glm::ivec3 dims, glm::ivec3 v) {
    return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
           std::size_t(v.x);
}

volume::Volume emptyCube(int side) {
    volume::Volume cube;
    cube.geometry = volume::makeGeometry(glm::ivec3(side));
    cube.bytes.resize(cube.geometry.voxelCount());
    return cube;
}

} // namespace

std::optional<GrowingCase> brainCase(const std::string& path) {
    if (!std::filesystem::exists(path)) {
        return std::nullopt;
    }
    return GrowingCase{"brain", volume::readVolume(path).volume, {{150, 185, 200}}, {40, 130}, {}};
}

GrowingCase airCase(int side) {
    auto body = phantom::makeBodyPhantom({.dims = glm::ivec3(side)});
    return {fmt::format("air of {}^3", side), std::move(body.volume), {glm::ivec3(0)}, {-1024, -500}, {}};
}

GrowingCase compactCase(std::uint64_t voxels, bool isSpeckled) {
    // 8 Gamma(5/4)^3 / Gamma(7/4) r^3
    const double radius = std::cbrt(double(voxels) / 6.4819);
    const int side = 2 * int(std::ceil(radius)) + 12;
    auto cube = emptyCube(side);
    const glm::ivec3 middle(side / 2);
    inParallel(side, [&](int z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::dvec3 q = glm::dvec3(glm::ivec3(x, y, z) - middle) / radius;
                const glm::dvec3 squares = q * q;
                if (glm::dot(squares, squares) < 1) {
                    const std::size_t n = indexIn(cube.geometry.dims, {x, y, z});
                    const bool isSpeckle = isSpeckled && phantom::randomBits(n) % 100 == 0;
                    cube.bytes[n] = std::byte(isSpeckle ? kSpeckle : kInside);
                }
            }
        }
    });
    cube.bytes[indexIn(cube.geometry.dims, middle)] = std::byte(kInside);
    computeRange(cube);
    return {isSpeckled ? "compact, speckled" : "compact",
            std::move(cube),
            {middle},
            kNarrow,
            isSpeckled ? std::optional(kWide) : std::nullopt};
}

GrowingCase thinCase(int voxels) {
    // Every other row and every other slice of the cube, joined at alternate ends.
    const int side = std::max(8, int(std::ceil(std::cbrt(4.2 * voxels))) / 2 * 2 + 3);
    auto cube = emptyCube(side);
    glm::ivec3 at(0);
    glm::ivec3 way(1, 1, 1);
    int rowSteps = 0;   // left between two rows
    int sliceSteps = 0; // left between two slices
    for (int n = 0; n < voxels && at.z < side; ++n) {
        cube.bytes[indexIn(cube.geometry.dims, at)] = std::byte(kInside);
        const auto isInside = [side](int v) { return v >= 0 && v < side; };
        if (sliceSteps > 0) {
            ++at.z;
            if (--sliceSteps == 0) {
                way.x = -way.x;
                way.y = -way.y;
            }
        } else if (rowSteps > 0) {
            at.y += way.y;
            way.x = --rowSteps == 0 ? -way.x : way.x;
        } else if (isInside(at.x + way.x)) {
            at.x += way.x;
        } else if (isInside(at.y + 2 * way.y)) {
            at.y += way.y;
            rowSteps = 1;
        } else {
            ++at.z;
            sliceSteps = 1;
        }
    }
    computeRange(cube);
    return {"thin", std::move(cube), {glm::ivec3(0)}, kNarrow, {}};
}

} // namespace vs
