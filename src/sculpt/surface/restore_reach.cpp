// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/restore_reach.h"

#include "base/check.h"
#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

namespace vs::sculpt {

RestoreReach::RestoreReach()
    : program_("sculpt/shaders/measure_restore.comp"), points_(4, "restored points"),
      directions_(4, "restored directions"), reach_(4, "restore reach") {}

std::vector<float> RestoreReach::measure(const field::Scene& scene,
                                         std::span<const field::SurfacePoint> points,
                                         std::span<const glm::vec3> directions, std::span<const float> depths,
                                         int radius) {
    VS_CHECK_EQ(points.size(), directions.size());
    VS_CHECK_EQ(points.size(), depths.size());
    if (points.empty() || scene.sculpture == nullptr) {
        return std::vector<float>(points.size(), 0.0F);
    }
    const gl::Pass pass("measure restore");
    const volume::GridGeometry& geometry = scene.data->geometry;
    const glm::dmat3 voxelFromSteps(geometry.voxelFromWorld() * geometry.stepMm());
    std::vector<glm::vec4> ways;
    ways.reserve(directions.size());
    for (std::size_t n = 0; n < directions.size(); ++n) {
        ways.emplace_back(-glm::vec3(voxelFromSteps * glm::dvec3(directions[n])), depths[n]);
    }
    points_.reserve(points.size_bytes());
    points_.write(points);
    directions_.reserve(ways.size() * sizeof(glm::vec4));
    directions_.write(std::span<const glm::vec4>(ways));
    reach_.reserve(points.size() * sizeof(float));
    binding_.bind(scene);
    points_.bindStorage(kPointsStorage);
    directions_.bindStorage(kWaysStorage);
    reach_.bindStorage(kReachStorage);
    program_.set("count", int(points.size())).set("radius", float(radius));
    program_.dispatchOverList(points.size(), gl::Barrier::All); // the sculpture that this reads changes next
    return reach_.read<float>(points.size());
}

} // namespace vs::sculpt
