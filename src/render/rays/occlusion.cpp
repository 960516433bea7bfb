// SPDX-License-Identifier: Apache-2.0
#include "render/rays/occlusion.h"

#include "base/check.h"
#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <cmath>

namespace vs::render {

namespace {

// Length in mm that distances are measured in: the edge of a cube as large as a texel.
double texelMm(const volume::GridGeometry& geometry, glm::ivec3 block) {
    const glm::dvec3 size = geometry.spacing() * glm::dvec3(block);
    return std::cbrt(size.x * size.y * size.z);
}

// Texels that depend on voxels: each looks at most half a voxel beyond its own.
Box3 texelsOf(const Box3& voxels, glm::ivec3 block, glm::ivec3 limit) {
    const Box3 grown = grow(voxels, 1);
    return intersect({glm::max(grown.lo, 0) / block, (grown.hi + block - 1) / block}, {glm::ivec3(0), limit});
}

// Texels of the next level that depend on texels of this one: texel t takes 2t - 1 to 2t + 2.
Box3 parentsOf(const Box3& texels, glm::ivec3 limit) {
    return intersect({glm::max(texels.lo - 1, 0) / 2, texels.hi / 2 + 1}, {glm::ivec3(0), limit});
}

} // namespace

glm::dvec3 towardsKeyLight(const ViewRays& rays) {
    return glm::normalize(-0.45 * glm::normalize(rays.right) + 0.65 * glm::normalize(rays.up) -
                          0.75 * rays.forward);
}

glm::ivec3 OcclusionVolume::blockSize(const volume::GridGeometry& geometry) {
    constexpr std::size_t large = 400UL * 400UL * 400UL;
    const glm::dvec3 spacing = geometry.spacing();
    const double voxels = geometry.voxelCount() > large ? 4 : 2;
    const double target = voxels * std::cbrt(spacing.x * spacing.y * spacing.z);
    glm::ivec3 block(1);
    for (int axis = 0; axis < 3; ++axis) {
        block[axis] = 1 << std::clamp(int(std::lround(std::log2(target / spacing[axis]))), 0, 3);
    }
    return block;
}

void OcclusionVolume::allocate(const volume::GridGeometry& geometry) {
    if (texels_ && geometry_ == geometry) {
        return;
    }
    blockSize_ = blockSize(geometry);
    // A multiple of the coarsest texel, so that each texel covers eight of the level before.
    const glm::ivec3 size = divideUp((geometry.dims + blockSize_ - 1) / blockSize_, 1 << (kLevels - 1));
    if (!scene_) {
        block_ = gl::Buffer(sizeof(OcclusionBlock), "occlusion");
        scene_.emplace();
    }
    texels_ = gl::Texture::pyramid(size << (kLevels - 1), gl::Format::R8, kLevels, "occlusion");
    geometry_ = geometry;
}

gl::Defines OcclusionVolume::definesFor(const Input& input) const {
    const int content = input.classification != nullptr ? 3
                        : !input.drawsSegmentation      ? 0
                        : input.drawsData               ? 2
                                                        : 1;
    gl::Defines defines = gl::switchesOn({
        {"SCULPTED", field::hasHiddenSide(input.scene)},
        {"ON_VOXELS", blockSize_ == glm::ivec3(2)},
    });
    field::addFill(input.scene, defines);
    defines.emplace_back("CONTENT", std::to_string(content));
    if (input.classification != nullptr) {
        input.classification->addDefines(defines);
    } else {
        defines.emplace_back("TF_KIND", "0");
    }
    return defines;
}

void OcclusionVolume::fill(const Input& input, const Box3& texels) {
    gl::Program& program = fill_.with(definesFor(input));
    scene_->bind(input.scene);
    if (input.classification != nullptr) {
        input.classification->bind();
    }
    if (input.macrocells != nullptr) {
        input.macrocells->bind();
    }
    // Texels look half a voxel beyond their own, so the cells around theirs must be empty too; eight voxels
    // take two cells.
    const bool isInOneCell = glm::all(glm::lessThanEqual(blockSize_, glm::ivec3(field::kCell)));
    const int farEnough = input.macrocells == nullptr ? 256 : isInOneCell ? 2 : 3;
    texels_.bindImage(kOcclusionImage, gl::Access::Write, 0);
    program.set("texelLo", texels.lo)
        .set("texelHi", texels.hi)
        .set("blockSize", blockSize_)
        .set("farEnough", farEnough)
        .set("texelSteps", float(texelMm(geometry_, blockSize_) / geometry_.stepMm()))
        .set("places", 8);
    program.dispatchOver(texels.size(), gl::Barrier::Texture);
}

void OcclusionVolume::average(int level, const Box3& texels) {
    texels_.bindTexture(kOcclusionTexture);
    texels_.bindImage(kAveragesImage, gl::Access::Write, level);
    gl::Program& program = average_.with({});
    program.set("texelLo", texels.lo).set("texelHi", texels.hi).set("level", level - 1);
    program.dispatchOver(texels.size(), gl::Barrier::Texture);
}

void OcclusionVolume::rebuild(const Input& input) { update(input, input.scene.data->geometry.box()); }

void OcclusionVolume::update(const Input& input, const Box3& voxels) {
    VS_CHECK(input.scene.data != nullptr);
    const gl::Pass pass("occlusion");
    const volume::GridGeometry& geometry = input.scene.data->geometry;
    const bool isNew = !texels_ || geometry_ != geometry;
    allocate(geometry);
    Box3 box = texelsOf(isNew ? geometry.box() : voxels, blockSize_, texels_.size());
    if (box.isEmpty()) {
        return;
    }
    fill(input, box);
    for (int level = 1; level < kLevels; ++level) {
        box = parentsOf(box, texels_.size(level));
        average(level, box);
    }
}

void OcclusionVolume::bind(const Light& light) {
    VS_CHECK(bool(texels_));
    const glm::dvec3 size(texels_.size());
    const glm::dvec3 block(blockSize_);
    const double unit = texelMm(geometry_, blockSize_);
    const glm::dmat3 voxelFromWorld(geometry_.voxelFromWorld());
    const glm::dmat3 worldFromVoxel(geometry_.worldFromVoxel);
    OcclusionBlock data;
    data.occlusionScale = glm::vec4(1.0 / (block * size), 0.0);
    data.occlusionOffset = glm::vec4(0.5 / (block * size), 0.0);
    for (int axis = 0; axis < 3; ++axis) {
        data.occlusionFromWorld[axis] = glm::vec4(voxelFromWorld[axis] * unit / (block * size), 0.0);
        data.occlusionTexel[axis] = glm::vec4(worldFromVoxel[axis] * block[axis] / unit, 0.0);
    }
    data.occlusionTowardsKey = glm::vec4(glm::normalize(light.towardsKey), 0.0);
    data.occlusionStrengths = glm::vec4(glm::dvec4(light.ambientOcclusion, light.shadows, 0, 0));
    data.occlusionLevels = glm::ivec4(kLevels, kLevels - 1, 0, 0);
    block_.writeValue(data);
    block_.bindUniform(kOcclusionBlock);
    texels_.bindTexture(kOcclusionTexture);
}

} // namespace vs::render
