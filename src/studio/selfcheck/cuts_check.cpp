// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "reference/radiation.h"
#include "sculpt/sculpture/brick_backup.h"
#include "sculpt/surface/tool_cut.h"

#include <cmath>
#include <numbers>

namespace vs::studio {

namespace {

constexpr double kSlabSurface = 10.3; // z of a slab's surface, voxels
constexpr double kDrillDepth = 8;
constexpr glm::dvec2 kDrillAxis(17, 15.5);
constexpr double kDrillRadius = 8; // its radius
constexpr double kSweepBegin = 3;  // of the surface, where a sweep begins: the radius

// The points on which a mask stands on a plane, looked at along +z.
std::vector<field::SurfacePoint> slabUnder(const sculpt::MaskRaster& mask) {
    std::vector<field::SurfacePoint> points;
    forEachVoxel({glm::ivec3(0), {mask.size, 1}}, [&](glm::ivec3 e, std::size_t) {
        const glm::dvec2 place = mask.origin + mask.pitch * glm::dvec2(e);
        points.push_back({glm::vec4(place, kSlabSurface, 1), glm::vec4(0, 0, -1, 0)});
    });
    return points;
}

// What a drill radiates: the mask's values on their whole way, as points a quarter of a voxel apart.
std::vector<glm::vec4> drilledPoints(const sculpt::MaskRaster& mask) {
    constexpr double pitch = 0.25;
    std::vector<glm::vec4> points;
    forEachVoxel({glm::ivec3(0), {mask.size, 1}}, [&](glm::ivec3 e, std::size_t n) {
        const glm::dvec2 place = mask.origin + mask.pitch * glm::dvec2(e);
        const double energy = double(mask.values[n]) * mask.pitch * mask.pitch * pitch;
        for (double t = 0.5 * pitch - kSweepBegin; t < kDrillDepth && energy > 0; t += pitch) {
            points.emplace_back(place, kSlabSurface + t, energy);
        }
    });
    return points;
}

// The convolution of a ball of this radius with a Gaussian whose sigma is 1, at a distance from its centre.
double blurredBall(double radius, double distance) {
    const auto bell = [](double x) { return std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi); };
    const auto rise = [](double x) { return 0.5 * std::erf(x / std::numbers::sqrt2); };
    return rise(radius - distance) + rise(radius + distance) -
           (bell(radius - distance) - bell(radius + distance)) / distance;
}

} // namespace

void checkDrill(Tally& tally) {
    const auto geometry = volume::makeGeometry({34, 32, 30});
    const auto mask = sculpt::rasterize(sculpt::circleOutline(kDrillAxis, kDrillRadius), 0.5);
    const auto surface = slabUnder(mask);
    sculpt::Sculpture sculpture(geometry.dims);
    sculpt::ToolCutter cutter(geometry);
    sculpt::ToolCut how;
    how.sweep.depthSteps = kDrillDepth;
    sculpt::BrickBackup backup(sculpture.texels());
    cutter.cut(sculpture, surface, mask, how, &backup);
    const auto expected =
        reference::radiate(drilledPoints(mask), geometry.dims, sculpt::fitFootprint(3).sigmaVoxels);
    const auto found = sculpture.values(geometry.box());
    forEachVoxel(geometry.box(), [&](glm::ivec3 v, std::size_t n) {
        // The program has fewer points, as far apart as voxels: its edges are a little steeper, most where
        // one of them stands for several elements of the mask.
        const bool isWall = std::abs(glm::length(glm::dvec2(v) - kDrillAxis) - kDrillRadius) < 4;
        tally.about(isWall ? "values at the wall" : "values of the hole and beside it");
        tally.compare(double(found[n]), std::clamp(double(expected[n]), 0.0, 1.0), isWall ? 0.04 : 0.02);
    });
    how.how = sculpt::Combine::Restore;
    cutter.cut(sculpture, surface, mask, how, &backup);
    tally.about("what restoring leaves, below one half");
    for (const float value : sculpture.values(geometry.box())) {
        tally.require(value < 0.5F);
    }
    auto delta = backup.finish();
    sculpture.swap(delta);
    tally.about("what undo leaves");
    for (const float value : sculpture.values(geometry.box())) {
        tally.compare(double(value), 0);
    }
}

void checkPeel(Tally& tally) {
    constexpr glm::ivec3 dims(48, 48, 40);
    constexpr glm::dvec3 centre(23.5, 24.2, 38);
    constexpr double radius = 30;
    constexpr double layers = 5;
    constexpr double opening = 13; // radius of the mask
    const auto mask = sculpt::rasterize(sculpt::circleOutline(glm::dvec2(centre), opening), 0.5);
    std::vector<field::SurfacePoint> surface;
    forEachVoxel({glm::ivec3(0), {mask.size, 1}}, [&](glm::ivec3 e, std::size_t) {
        const glm::dvec2 off = mask.origin + mask.pitch * glm::dvec2(e) - glm::dvec2(centre);
        const glm::dvec3 normal(off / radius, -std::sqrt(radius * radius - glm::dot(off, off)) / radius);
        surface.push_back({glm::vec4(centre + radius * normal, 1), glm::vec4(normal, 0)});
    });
    sculpt::Sculpture sculpture(dims);
    sculpt::ToolCut how;
    how.sweep.direction = sculpt::ToolDirection::OwnNormal;
    how.sweep.depthSteps = layers;
    sculpt::ToolCutter(volume::makeGeometry(dims)).cut(sculpture, surface, mask, how, nullptr);
    const auto found = sculpture.values({glm::ivec3(0), dims});
    forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t n) {
        const glm::dvec3 off = glm::dvec3(v) - centre;
        const double distance = glm::length(off);
        const double across = glm::length(glm::dvec2(off)) * radius / std::max(distance, 1.0);
        if (distance < radius - layers - 6 || off.z > 0) {
            tally.about("values below the cut");
            tally.compare(double(found[n]), 0, 1e-3);
        } else if (across > opening + 6) {
            tally.about("values beside the cut");
            tally.compare(double(found[n]), 0, 1e-3);
        } else if (across < opening - 6) {
            tally.about("values of a shell");
            tally.compare(
                double(found[n]),
                blurredBall(radius + kSweepBegin, distance) - blurredBall(radius - layers, distance), 0.03);
        }
    });
}

} // namespace vs::studio
