// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cutter.h"

#include "gl/pass.h"

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

void Cutter::follow(const volume::GridGeometry& corrected) {
    tools.follow(corrected);
    solids.follow(corrected);
}

std::vector<float> Cutter::sculptureAsFloats() const { return sculpture->values(geometry->box()); }

} // namespace vs::studio
