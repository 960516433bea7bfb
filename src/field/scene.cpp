// SPDX-License-Identifier: Apache-2.0
#include "field/scene.h"

#include "base/check.h"
#include "field/shaders/bindings.h"

#include <algorithm>

namespace vs::field {

SceneBinding::SceneBinding()
    : block_(sizeof(SceneBlock), "scene"),
      empty_(glm::ivec3(1), gl::Format::R8, gl::Filter::Nearest, "empty"),
      segment1_(glm::ivec3(1), gl::Format::R8UI, gl::Filter::Nearest, "segment 1") {
    segment1_.clear(1);
}

void SceneBinding::bind(const Scene& scene) {
    VS_CHECK(scene.data != nullptr);
    const Field& data = *scene.data;
    SceneBlock block;
    block.worldFromVoxel = glm::mat4(data.geometry.worldFromVoxel);
    block.voxelFromWorld = glm::mat4(data.geometry.voxelFromWorld());
    block.dims = glm::ivec4(data.geometry.dims, int(scene.view));
    block.spacing = glm::vec4(glm::vec3(data.geometry.spacing()), float(data.geometry.stepMm()));
    block.valueScale = {data.valueScale, data.valueOffset, data.isIntegral ? 1.0F : 0.0F,
                        float(toleranceAt(scene.displayedRange.lo, data))};
    // Never below the data, so that the stand-in for non-finite voxels (which only float fields have) is
    // outside.
    const double lo =
        data.isIntegral ? scene.displayedRange.lo : std::max(scene.displayedRange.lo, data.range.lo);
    constexpr float beyondAllValues = 1e30F; // a range's width must have a reciprocal
    block.range = {float(lo), std::min(float(scene.displayedRange.hi), beyondAllValues),
                   float(scene.greyWindow.lo), float(scene.greyWindow.hi)};
    block.limits.w = float(toleranceAt(scene.displayedRange.hi, data));
    block.limits.x = scene.showsAbove ? beyondAllValues : block.range.y;
    block.sceneFlags =
        glm::vec4(scene.segmentation != nullptr ? 1.0F : 0.0F, 1.0F / glm::vec3(data.geometry.dims));
    if (scene.smoothed != nullptr) {
        block.limits.y = scene.smoothed->valueScale;
        block.limits.z = scene.smoothed->valueOffset;
    }
    block_.writeValue(block);
    block_.bindUniform(kSceneBlock);
    data.texels.bindTexture(kDataTexture);
    if (data.quads) {
        data.quads.bindTexture(kQuadsTexture);
    }
    if (scene.smoothed != nullptr) {
        scene.smoothed->texels.bindTexture(kSmoothedTexture);
        if (scene.smoothed->quads) {
            scene.smoothed->quads.bindTexture(kSmoothedQuadsTexture);
        }
    }
    (scene.sculpture != nullptr ? *scene.sculpture : empty_).bindTexture(kSculptureTexture);
    (scene.segmentation != nullptr ? *scene.segmentation : empty_).bindTexture(kSegmentationTexture);
    if (scene.apartPages != nullptr) {
        scene.apartTiles->bindTexture(kApartTilesTexture);
        scene.apartPages->bindTexture(kApartPagesTexture);
    }
    if (scene.marks != nullptr) {
        scene.marks->bind(data.geometry);
    }
    if (scene.fill != nullptr) {
        scene.fill->bind(scene.materials);
    }
    (scene.segmentLabels != nullptr ? *scene.segmentLabels : segment1_).bindTexture(kSegmentLabelsTexture);
}

bool hasHiddenSide(const Scene& scene) {
    return scene.sculpture != nullptr || scene.view == SculptureView::Probe ||
           (scene.fill != nullptr && !areAllSeen(scene.materials));
}

void addFill(const Scene& scene, gl::Defines& defines) {
    if (scene.fill != nullptr) {
        defines.emplace_back("FILLED", areAllSeen(scene.materials) ? "1" : "2");
    }
}

} // namespace vs::field
