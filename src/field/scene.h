// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "field/fill/fill_texture.h"
#include "field/marks/mark_texture.h"
#include "gl/block_layout.h"
#include "gl/buffer.h"
#include "gl/shader_source.h"

#include <array>

namespace vs::field {

enum class SculptureView { Whole, Cut, Probe };
inline constexpr std::array<const char*, 3> kSculptureViews{"whole", "cut", "probe"};
constexpr const auto& namesOf(SculptureView) { return kSculptureViews; }

// What the data is between voxel centres. Tricubic is the cubic B-spline of the stored values, not
// prefiltered: smooth without the facets of trilinear interpolation, and a little softer than the data (a
// voxel counts with 8/27 at its own centre). Shaders sample that way with TRICUBIC defined.
enum class Sampling { Trilinear, Tricubic };
inline constexpr std::array<const char*, 2> kSamplings{"linear", "cubic"};
constexpr const auto& namesOf(Sampling) { return kSamplings; }

// What every shader that samples the document needs to know; mirrors SceneBlock in field/shaders/scene.glsl
// (std140).
struct SceneBlock {
    glm::mat4 worldFromVoxel{1};
    glm::mat4 voxelFromWorld{1};
    glm::ivec4 dims{0};   // xyz: voxels, w: SculptureView
    glm::vec4 spacing{1}; // xyz: mm, w: step in mm
    glm::vec4 valueScale{
        1}; // x scale, y offset, z 1 if values are whole numbers, w tolerance at the lower end of the range
    glm::vec4 range{0};      // xy displayed range, zw grey window of cut faces, in the field's unit
    glm::vec4 sceneFlags{0}; // x: 1 if there is a segmentation, yzw: 1 / dims
    glm::vec4 limits{0};     // x: the greatest value that is visible, yz: scale and offset of `smoothed`
};
inline constexpr gl::BlockMember kSceneBlockMembers[] = {
    VS_BLOCK_MEMBER(SceneBlock, worldFromVoxel), VS_BLOCK_MEMBER(SceneBlock, voxelFromWorld),
    VS_BLOCK_MEMBER(SceneBlock, dims),           VS_BLOCK_MEMBER(SceneBlock, spacing),
    VS_BLOCK_MEMBER(SceneBlock, valueScale),     VS_BLOCK_MEMBER(SceneBlock, range),
    VS_BLOCK_MEMBER(SceneBlock, sceneFlags),     VS_BLOCK_MEMBER(SceneBlock, limits)};
inline constexpr gl::BlockLayout kSceneBlockLayout{"SceneBlock", sizeof(SceneBlock), kSceneBlockMembers};
static_assert(isWhole(kSceneBlockLayout));

// The document as shaders see it: data, sculpture (null: nothing cut), segmentation (null: none), displayed
// range, view. How segments look is not part of it: render::SegmentColours.
struct Scene {
    const Field* data = nullptr;
    const gl::Texture* sculpture = nullptr;
    // Whether some faces of the sculpture lie on segments' own surfaces, because tools spared those or took
    // nothing else.
    bool isCutAlongSegments = false;
    // Whether what lies over the bricks of finer levels (field::Detail::lay()) says more exactly what is cut.
    bool hasFinerCuts = false;
    // Whether other texels over those bricks say more exactly what belongs to segments.
    bool hasFinerSegments = false;
    // Anti-aliased membership, 0 to 1, surfaces at 0.5: red of all visible opaque segments together, green of
    // all visible translucent ones (a texture of one channel has none). Hidden segments are in neither.
    const gl::Texture* segmentation = nullptr;
    // R8UI, nearest: which segment a voxel belongs to, 0 none. Null: everything segmented is of segment 1.
    const gl::Texture* segmentLabels = nullptr;
    // What one segment has alone where others touch it, and where that lies (one_segment.glsl). Null: not
    // known, and not needed where one segment is all there is.
    const gl::Texture* apartTiles = nullptr; // R8, linear
    const gl::Texture* apartPages = nullptr; // R32UI, a texel for each tile
    const MarkTexture* marks = nullptr;      // colours laid on the material; null: none
    const FillTexture* fill = nullptr;       // material that was added; null: none
    ShownMaterials materials = {};           // and what it is
    Range displayedRange;
    // Values above the displayed range are visible too, and count as its upper end (MIP, X-ray).
    bool showsAbove = false;
    // What surfaces are looked for in, instead of the data; null: the data. Shaders with SMOOTHED defined do
    // so.
    const Field* smoothed = nullptr;
    Range greyWindow;
    SculptureView view = SculptureView::Cut;
    Sampling sampling = Sampling::Trilinear; // of the data; sculpture and segmentation are always trilinear
};

// Binds a scene: uniform block 0, textures 0 (data), 1 (sculpture), 2 (segmentation), 13 (labels), 6 (the
// data's quads, where it has them), 15 and 12 (the same of smoothed values), 7 and 15 (a segment alone);
// texture 16 and uniform block 5 (marks, where there are any: MARKS, marks.glsl), texture 17 and uniform
// block 6 (material, where there is any: addFill(), fill.glsl). Shaders include "field/shaders/scene.glsl"
// and call sampleScene(); with QUADS defined they sample the quads. Those units and uniform block 0 are taken
// while it is bound.
class SceneBinding {
public:
    SceneBinding();
    void bind(const Scene& scene);

private:
    gl::Buffer block_;
    gl::Texture empty_;    // stands in for what a scene does not have: one texel of zero
    gl::Texture segment1_; // the labels of a scene without: one texel of 1
};

// Whether some of what the scene has may not be seen because it was cut away, or material that is not seen is
// there instead.
bool hasHiddenSide(const Scene& scene);
// Programs that show the scene have FILLED defined where it has a fill.
void addFill(const Scene& scene, gl::Defines& defines);

} // namespace vs::field
