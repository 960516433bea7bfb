// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/detail.h"
#include "field/scene.h"
#include "gl/program.h"
#include "image/image.h"
#include "render/colours/classification.h"
#include "render/colours/segment_colours.h"
#include "render/slices/slice_view.h"

namespace vs::render {

// Everything one picture of a slice depends on. The pointers must stay alive until it is drawn.
struct SliceFrame {
    field::Scene scene;
    field::Detail* detail = nullptr; // finer levels of its data, as render::Frame has them
    Range window;                    // the values that are shown from black to white
    // Tints, over the greys, the values that the 3D picture shows: by its function, or for null in one tint.
    bool tintsVisible = false;
    Range visible;
    const Classification* classification = nullptr;
    SegmentColours segmentColours;
    SliceView view;
    bool isSmooth = true; // interpolated between voxels; else every voxel is a plain area
    float fill = 0.4F;    // opacity of the inside of opaque segments; their outlines always show
    float outlinePixels = 1.25F;
};

// Draws slices in a compute shader: values in greys of the window (black below, white above) and, where that
// is asked for, those that the 3D picture shows in a tint or in the transfer function's colours; what the
// sculpture hides darkened and hatched, segments as a translucent area with an outline. A slice lies on voxel
// centres, so its values are interpolated within it and with isSmooth off they are the voxels' own.
// Segments, and what is cut, are those of the level whose values are shown, or of the scene: exact at voxel
// centres, and where two segments touch both have an outline.
class SliceRenderer {
public:
    // Where the frame has finer levels the one is used that its pixels ask for; bricks that are not there are
    // asked for, and waited for as long as `waitMs`.
    void render(const SliceFrame& frame, double waitMs = 1e9);
    // Whether the picture has less than its pixels ask for, in places whose bricks are still to come.
    [[nodiscard]] bool missesBricks() const { return missesBricks_; }
    // The picture: RGBA8, of the last frame's size, rows from the top.
    [[nodiscard]] const gl::Texture& picture() const { return picture_; }
    [[nodiscard]] image::Image readPicture() const;

private:
    gl::ProgramVariants draw_{"render/shaders/draw_slice.comp"};
    field::SceneBinding sceneBinding_;
    gl::Buffer segmentColours_{sizeof(SegmentColours), "segment colours of slices"};
    void draw(const SliceFrame& frame, gl::Program& program);

    gl::Texture picture_;
    bool missesBricks_ = false;
};

} // namespace vs::render
