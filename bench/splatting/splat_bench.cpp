// SPDX-License-Identifier: Apache-2.0
// splat_bench: the same points radiated by sculpt::Radiator and by splatting each of them, timed and
// compared.
#include "base/error.h"
#include "base/statistics.h"
#include "base/timer.h"
#include "gl/context.h"
#include "sculpt/radiation/radiation.h"
#include "sculpt/radiation/tool_points.h"
#include "sculpt/surface/tool_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace vs {

namespace {

constexpr int kRuns = 9;
constexpr const char* kFixedOne = "4194304.0";

// The points of one stamp and the grid they lie in.
struct Scene {
    std::string name;
    glm::ivec3 dims{0};
    gl::Buffer points;
    std::size_t count = 0;
    Box3 pointBox;
};

using Surface = std::function<field::SurfacePoint(glm::dvec2)>;

field::SurfacePoint pointAt(glm::dvec3 voxel, glm::dvec3 normal) {
    return {glm::vec4(glm::vec3(voxel), 1), glm::vec4(glm::vec3(normal), 0)};
}

Scene sceneOf(const std::string& name, glm::ivec3 dims, const sculpt::MaskRaster& mask,
              const sculpt::ToolSweep& sweep, const Surface& surfaceAt) {
    std::vector<field::SurfacePoint> surface;
    for (int j = 0; j < mask.size.y; ++j) {
        for (int i = 0; i < mask.size.x; ++i) {
            surface.push_back(surfaceAt(mask.origin + mask.pitch * glm::dvec2(i, j)));
        }
    }
    const auto patches = sculpt::sweepSurface(surface, mask, volume::makeGeometry(dims), sweep);
    std::vector<glm::vec4> points;
    sculpt::PointGenerator().generate(patches, [&](const gl::Buffer& chunk, std::size_t count) {
        const auto more = chunk.read<glm::vec4>(count);
        points.insert(points.end(), more.begin(), more.end());
    });
    Scene scene{name, dims, gl::Buffer(points.size() * sizeof(glm::vec4), "points"), points.size(),
                patches.pointBox()};
    scene.points.write(std::span<const glm::vec4>(points));
    return scene;
}

// A mask of 100 x 100 elements drilled 10 steps into a plane.
Scene drillStamp(int radius) {
    const auto mask = sculpt::rasterize(sculpt::circleOutline({80, 80}, 24), 0.5);
    sculpt::ToolSweep sweep;
    sweep.depthSteps = 10;
    sweep.radius = radius;
    return sceneOf("drill stamp", {160, 160, 96}, mask, sweep, [](glm::dvec2 e) {
        return pointAt({e, 30}, {0, 0, -1});
    });
}

// A mask of 300 x 300 elements, one layer off a ball of radius 120.
Scene peelLayer(int radius) {
    const auto mask = sculpt::rasterize(sculpt::circleOutline({128, 128}, 74), 0.5);
    sculpt::ToolSweep sweep;
    sweep.direction = sculpt::ToolDirection::OwnNormal;
    sweep.depthSteps = 1;
    sweep.radius = radius;
    return sceneOf("peel layer", {256, 256, 128}, mask, sweep, [](glm::dvec2 e) {
        const glm::dvec2 off = e - 128.0;
        const glm::dvec3 normal(off / 120.0, -std::sqrt(120.0 * 120 - glm::dot(off, off)) / 120);
        return pointAt(glm::dvec3(128, 128, 130) + 120.0 * normal, normal);
    });
}

// Splats into the box that the points of a scene reach.
class Splatter {
public:
    Splatter(const Scene& scene, int radius, bool bySlices)
        : box_{scene.pointBox.lo - radius - 1, scene.pointBox.hi + radius + 1},
          splat_("splat_points.comp", {{"RADIUS", std::to_string(radius)},
                                       {"SLICES", std::to_string(bySlices ? 2 * radius : 1)},
                                       {"FIXED_ONE", kFixedOne}}),
          resolve_("resolve_splats.comp", {{"FIXED_ONE", kFixedOne}}),
          splatted_(box_.size(), gl::Format::R32UI, gl::Filter::Nearest, "splatted"),
          energy_(box_.size(), gl::Format::R32F, gl::Filter::Nearest, "splat energy"),
          slices_(bySlices ? 2 * radius : 1) {}

    void run(const Scene& scene) {
        scene.points.bindStorage(0);
        splatted_.bindImage(0, gl::Access::ReadWrite);
        energy_.bindImage(1, gl::Access::Write);
        splat_.set("count", int(scene.count)).set("originVoxel", box_.lo);
        splat_.dispatchOver({int(scene.count) * slices_, 1, 1}, gl::Barrier::All);
        resolve_.dispatchOver(box_.size(), gl::Barrier::All);
    }
    [[nodiscard]] const Box3& box() const { return box_; }
    [[nodiscard]] std::vector<float> energies() const { return energy_.downloadAll<float>(); }

private:
    Box3 box_;
    gl::Program splat_;
    gl::Program resolve_;
    gl::Texture splatted_;
    gl::Texture energy_;
    int slices_;
};

double medianMs(const std::function<void()>& work) {
    work(); // compiles, allocates
    std::vector<double> times;
    for (int run = 0; run < kRuns; ++run) {
        gl::Context::finish();
        const Timer timer;
        work();
        gl::Context::finish();
        times.push_back(timer.milliseconds());
    }
    return median(times);
}

// Both fields over the grid, where splats may lie outside it: the largest difference.
float largestDifference(const sculpt::Radiator& radiator, const Splatter& splatter, glm::ivec3 dims) {
    const auto splatted = splatter.energies();
    const auto radiated = radiator.download(splatter.box());
    float worst = 0;
    std::size_t n = 0;
    for (int z = splatter.box().lo.z; z < splatter.box().hi.z; ++z) {
        for (int y = splatter.box().lo.y; y < splatter.box().hi.y; ++y) {
            for (int x = splatter.box().lo.x; x < splatter.box().hi.x; ++x, ++n) {
                const glm::ivec3 voxel(x, y, z);
                const bool inside = glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) &&
                                    glm::all(glm::lessThan(voxel, dims));
                worst = inside ? std::max(worst, std::abs(splatted[n] - radiated[n])) : worst;
            }
        }
    }
    return worst;
}

// Times one scene both ways and prints a row; false when the two fields differ more than they may.
bool compare(const Scene& scene, int radius) {
    sculpt::Radiator radiator;
    const auto footprint = sculpt::fitFootprint(radius);
    const double radiated = medianMs([&] {
        radiator.begin(scene.pointBox, scene.dims, footprint);
        radiator.deposit(scene.points, scene.count);
        radiator.finish();
    });
    Splatter wholes(scene, radius, false);
    Splatter slices(scene, radius, true);
    const double byPoint = medianMs([&] { wholes.run(scene); });
    const double bySlice = medianMs([&] { slices.run(scene); });
    const float worst = largestDifference(radiator, wholes, scene.dims);
    // Points of a tool lie a voxel apart, and each way passes a little of that lattice.
    constexpr float allowed = 0.02F;
    fmt::print("| {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.4f} |\n", scene.name, radius,
               scene.count, radiated, byPoint, bySlice, std::min(byPoint, bySlice) / radiated, worst);
    return worst <= allowed;
}

int run() {
    const auto context = gl::Context::createHeadless();
    fmt::print(
        "{}\n\n| stamp | R | points | radiated (ms) | splatted, a point each (ms) | a slice each (ms) | "
        "ratio to the faster | largest difference |\n|---|---|---|---|---|---|---|---|\n",
        context.device().renderer);
    bool agrees = true;
    for (const int radius : {2, 3, 4}) {
        agrees = compare(drillStamp(radius), radius) && agrees;
        agrees = compare(peelLayer(radius), radius) && agrees;
    }
    context.requireNoErrors();
    if (!agrees) {
        fmt::print(stderr, "the two ways differ by more than the radiation is allowed to\n");
    }
    return agrees ? 0 : 1;
}

} // namespace

} // namespace vs

int main() {
    setenv("VOLUME_STUDIO_SHADER_DIR", SPLAT_SHADERS, 1);
    try {
        return vs::run();
    } catch (const vs::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
