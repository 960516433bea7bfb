// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "reference/rays.h"
#include "render/rays/picker.h"
#include "render/rays/ray_caster.h"

#include <functional>
#include <vector>

namespace vs::studio {

// One volume on the device and one view of it, on black, so that a pixel is as bright as what its ray has
// met: enough for pictures and for places on surfaces.
class Still {
public:
    Still(volume::Volume v, const Range& displayed, const render::Camera& camera, glm::ivec2 size);
    Still(const Still&) = delete;
    Still& operator=(const Still&) = delete;

    void look(const render::Camera& camera, glm::ivec2 size);

    // Functions of voxel coordinates, from 0 to 1: what is cut away, and what belongs to segment 1.
    using OfVoxel = std::function<double(glm::dvec3 voxel)>;
    void sculpt(const OfVoxel& part);
    void segment(const OfVoxel& part);
    void classify(const render::TransferFunction& function);

    // Pastes what is cut away where it was.
    void pasteInPlace();

    // A picture as the program makes it, and one for which nothing counts as empty.
    image::Image picture(render::Mode mode);
    image::Image marchedPicture(render::Mode mode);
    // What the rays through the centres of all pixels meet, rows from the top.
    std::vector<field::SurfacePoint> pick(render::Mode mode,
                                          render::Picker::Meets meets = render::Picker::Meets::Surface);

    [[nodiscard]] const volume::Volume& volume() const { return volume_; }
    [[nodiscard]] render::Frame& frame() { return frame_; }
    [[nodiscard]] glm::ivec2 size() const { return frame_.rays.size; }
    // The ray through a pixel's centre, in the world and in voxel space.
    [[nodiscard]] render::ViewRays::Ray rayOf(glm::ivec2 pixel) const;
    [[nodiscard]] reference::Ray plainRayOf(glm::ivec2 pixel) const;

private:
    void rebuild(render::Mode mode);
    gl::Texture textureOf(const OfVoxel& part, const char* label) const;
    gl::Texture rangesOf(const gl::Texture& texture) const;
    image::Image draw();

    volume::Volume volume_;
    field::Field field_;
    field::CellRanges cells_;
    gl::Texture sculpture_;
    gl::Texture sculptureCells_;
    gl::Texture segmentation_;
    gl::Texture segmentationCells_;
    render::Classification classification_;
    render::Macrocells macrocells_;
    render::Macrocells pastedMacrocells_;
    render::RayCaster caster_;
    render::Picker picker_;
    render::Frame frame_;
};

} // namespace vs::studio
