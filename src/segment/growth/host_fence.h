// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/brick_texels.h"
#include "segment/growth/constraints.h"

namespace vs::segment {

// On which side of the fence the voxels of a box lie. Internal to this folder.
class HostFence {
public:
    HostFence(const Constraints& constraints, const Box3& box)
        : texels_(*constraints.sculpture, box), format_(constraints.sculpture->format()),
          keepsCutPart_(constraints.view == field::SculptureView::Probe) {}

    [[nodiscard]] bool letsIn(glm::ivec3 voxel) const { return isCut(texels_.at(voxel)) == keepsCutPart_; }

private:
    [[nodiscard]] bool isCut(const std::byte* texel) const;

    BrickTexels texels_;
    gl::Format format_;
    bool keepsCutPart_;
};

} // namespace vs::segment
