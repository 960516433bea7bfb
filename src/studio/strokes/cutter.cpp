// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cutter.h"

#include "gl/pass.h"

#include <cmath>

namespace vs::studio {

const gl::Texture& Cutter::snapshot() {
    const gl::Pass pass("sculpture snapshot");
    const gl::Texture& texels = sculpture->texels();
    if (!snapshot_) {
        snapshot_ = gl::Texture(texels.size(), texels.format(), gl::Filter::Linear, "sculpture at pen-down");
    }
    const Box3 changed = sculpture->changedSince(snapshotVersion_);
    if (!changed.isEmpty()) {
        snapshot_.copyFrom(texels, changed, changed.lo);
    }
    snapshotVersion_ = sculpture->version();
    copiedVoxels_ = changed.volume();
    return snapshot_;
}

const render::Macrocells& Cutter::snapshot(const render::Macrocells& macrocells) {
    macrocells_.copyFrom(macrocells);
    return macrocells_;
}

field::Scene Cutter::restoreScene(const render::Frame& frame) {
    constexpr double everything = 1e29;
    field::Scene scene = frame.scene;
    if (frame.mode == render::Mode::Volume) {
        scene.displayedRange = {-everything, everything};
    }
    return scene;
}

Cutter::Finer Cutter::makeFiner(const field::Field& field) const {
    return {std::make_unique<Cutter>(field, *sculpture), sculpt::FineWindow(sculpture->precision())};
}

void Cutter::refine(Finer finer, field::Detail& detail) {
    rough_ = std::move(finer.rough);
    window_ = std::move(finer.window);
    detail_ = &detail;
    geometry = &finest_;
    follow(*scene);
}

void Cutter::follow(const volume::GridGeometry& corrected) {
    if (detail_ != nullptr) {
        finest_ = field::finerGeometry(corrected, sculpture->finer()->grid());
        toolSteps_ = corrected.stepMm() / finest_.stepMm();
    }
    if (rough_ != nullptr) {
        rough_->follow(corrected);
    }
    tools.follow(detail_ != nullptr ? finest_ : corrected);
    solids.follow(detail_ != nullptr ? finest_ : corrected);
}

std::unique_ptr<sculpt::CutTarget> Cutter::target(sculpt::BrickBackup& backup, sculpt::FineBricks& originals,
                                                  sculpt::Combine how) {
    if (detail_ != nullptr) {
        return std::make_unique<sculpt::FineTarget>(*sculpture, *window_, originals, backup);
    }
    const bool isOfFill = aim.at == Aim::At::Fill || aim.at == Aim::At::Filled;
    auto scan = std::make_unique<sculpt::WholeTarget>(*sculpture, &backup);
    if (!isOfFill && !(how == sculpt::Combine::Cut && cutsFill())) {
        return scan;
    }
    if (!fillWindow_) {
        fillWindow_.emplace();
    }
    auto filled =
        std::make_unique<sculpt::FillTarget>(*fill, aim.material, *fillWindow_, sculpture->limits());
    if (isOfFill) {
        return filled;
    }
    return std::make_unique<sculpt::CutWithFill>(std::move(scan), std::move(filled));
}

glm::dvec3 Cutter::toolPlace(const glm::dvec3& sceneVoxel) const {
    if (detail_ == nullptr) {
        return sceneVoxel;
    }
    const field::BrickGrid& grid = sculpture->finer()->grid();
    return sceneVoxel * grid.perSceneVoxel + grid.origin;
}

glm::dvec3 Cutter::scenePlace(const glm::dvec3& toolVoxel) const {
    if (detail_ == nullptr) {
        return toolVoxel;
    }
    const field::BrickGrid& grid = sculpture->finer()->grid();
    return (toolVoxel - grid.origin) / grid.perSceneVoxel;
}

void Cutter::keepSurfaces() {
    if (detail_ != nullptr) {
        kept_ = sculpture->finer()->snapshot();
        keptVersion_ = sculpture->finer()->version();
    }
}

std::vector<field::SurfacePoint> Cutter::pick(const render::Frame& frame, std::span<const glm::vec2> pixels) {
    const auto lay = [&](const std::shared_ptr<const field::BrickOverlay>& cuts, std::uint64_t version) {
        detail_->lay(field::BrickLayer::Cuts, cuts, version,
                     [this](std::uint64_t since) { return sculpture->finer()->changedSince(since); });
    };
    const bool isKept = detail_ != nullptr && kept_ != nullptr;
    if (isKept) {
        lay(kept_, keptVersion_);
    }
    auto points = picker.pickPoints(frame, pixels);
    if (isKept) { // a picture that goes on shows what is there now
        lay(sculpture->finer()->snapshot(), sculpture->finer()->version());
    }
    for (field::SurfacePoint& point : points) {
        point.voxel = glm::vec4(glm::vec3(toolPlace(glm::dvec3(point.voxel))), point.voxel.w);
    }
    return points;
}

std::vector<float> Cutter::reachOf(const render::Frame& frame, std::span<const field::SurfacePoint> points,
                                   std::span<const glm::vec3> directions, std::span<const float> depths,
                                   int radius) {
    const double steps = toolSteps();
    std::vector<field::SurfacePoint> inScene(points.begin(), points.end());
    for (field::SurfacePoint& point : inScene) {
        point.voxel = glm::vec4(glm::vec3(scenePlace(glm::dvec3(point.voxel))), point.voxel.w);
    }
    std::vector<float> sceneDepths(depths.begin(), depths.end());
    for (float& depth : sceneDepths) {
        depth = float(depth / steps);
    }
    auto reach = restoreReach.measure(restoreScene(frame), inScene, directions, sceneDepths,
                                      int(std::ceil(radius / steps)));
    for (float& each : reach) {
        each = float(each * steps);
    }
    return reach;
}

std::vector<float> Cutter::sculptureAsFloats() const { return sculpture->values(scene->box()); }

} // namespace vs::studio
