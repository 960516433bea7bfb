// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/scene.h"
#include "gl/block_layout.h"
#include "gl/program.h"
#include "render/camera/camera.h"
#include "render/colours/classification.h"
#include "render/space/macrocells.h"

#include <optional>

namespace vs::render {

// What shaders need to look light up; mirrors OcclusionBlock in render/shaders/occlusion.glsl (std140).
struct OcclusionBlock {
    glm::vec4 occlusionScale{0};      // xyz: texture coordinate per voxel
    glm::vec4 occlusionOffset{0};     // xyz: texture coordinate of voxel 0
    glm::vec4 occlusionFromWorld[3];  // texture coordinates per texel length along the world's x, y, z
    glm::vec4 occlusionTexel[3];      // xyz: edges of a texel, in the world, in texel lengths
    glm::vec4 occlusionTowardsKey{0}; // world, unit
    glm::vec4 occlusionStrengths{0};  // x ambient occlusion, y shadow
    glm::ivec4 occlusionLevels{0};    // x that ambient cones reach, y shadows
};
inline constexpr gl::BlockMember kOcclusionBlockMembers[] = {
    VS_BLOCK_MEMBER(OcclusionBlock, occlusionScale),      VS_BLOCK_MEMBER(OcclusionBlock, occlusionOffset),
    VS_BLOCK_MEMBER(OcclusionBlock, occlusionFromWorld),  VS_BLOCK_MEMBER(OcclusionBlock, occlusionTexel),
    VS_BLOCK_MEMBER(OcclusionBlock, occlusionTowardsKey), VS_BLOCK_MEMBER(OcclusionBlock, occlusionStrengths),
    VS_BLOCK_MEMBER(OcclusionBlock, occlusionLevels)};
inline constexpr gl::BlockLayout kOcclusionBlockLayout{"OcclusionBlock", sizeof(OcclusionBlock),
                                                       kOcclusionBlockMembers};
static_assert(isWhole(kOcclusionBlockLayout));

// Where the light comes from and how strongly what blocks it is seen; 0: as if nothing blocked it.
struct Light {
    glm::dvec3 towardsKey{0, -1, 0}; // world
    double ambientOcclusion = 1;
    double shadows = 1;
};

// The key light of render/shaders/shading.glsl for this viewer: from the upper left, in front.
glm::dvec3 towardsKeyLight(const ViewRays& rays);

// How much blocks the light, everywhere: a coarse volume of what is drawn and its averages over ever larger
// surroundings (a pyramid), which cones towards the light are looked up in (Crassin et al. 2011, "Interactive
// indirect illumination using voxel cone tracing"). Shaders include "render/shaders/occlusion.glsl". Holds no
// memory on the device before the first rebuild().
class OcclusionVolume {
public:
    static constexpr int kLevels = 6;

    struct Input {
        field::Scene scene;
        const Macrocells* macrocells = nullptr;         // what may be seen of that scene; null: everything
        const Classification* classification = nullptr; // null: surfaces
        bool drawsData = true;                          // surfaces only
        bool drawsSegmentation = false;                 // surfaces only
    };
    // Recomputes everything.
    void rebuild(const Input& input);
    // Recomputes what depends on `voxels`, where sculpture or segmentation have changed; everything if there
    // is nothing yet. Same result as rebuild(). Both leave texture units 0 to 7 and uniform blocks 0 and 2
    // changed.
    void update(const Input& input, const Box3& voxels);

    // Binds texture 9 and uniform block 3. rebuild() comes first.
    void bind(const Light& light);

    // Blocked part per texel, 0 to 255, with its pyramid; empty before the first rebuild().
    [[nodiscard]] const gl::Texture& texels() const { return texels_; }
    // Voxels per texel along each axis: powers of two that make texels about as long as wide, in mm.
    static glm::ivec3 blockSize(const volume::GridGeometry& geometry);

private:
    void allocate(const volume::GridGeometry& geometry);
    [[nodiscard]] gl::Defines definesFor(const Input& input) const;
    void fill(const Input& input, const Box3& texels);
    void average(int level, const Box3& texels);

    gl::ProgramVariants fill_{"render/shaders/fill_occlusion.comp"};
    gl::ProgramVariants average_{"render/shaders/average_occlusion.comp"};
    std::optional<field::SceneBinding> scene_;
    gl::Buffer block_;
    gl::Texture texels_;
    volume::GridGeometry geometry_; // that texels_ were made for
    glm::ivec3 blockSize_{1};
};

} // namespace vs::render
