// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "sculpt/radiation/swept_patches.h"

#include <cstddef>
#include <functional>

namespace vs::sculpt {

// Turns swept patches into points with calibrated energy, on the device: each sample of P(u, v, d) carries
// mask * |det dP| du dv dd voxels, so the density inside the solid is 1 whatever the mask's pitch, the zoom
// or the step.
class PointGenerator {
public:
    // Points of one chunk (vec4: xyz voxel space, w energy), and how many.
    using Consume = std::function<void(const gl::Buffer& points, std::size_t count)>;

    PointGenerator();
    // Makes the points chunk by chunk (at most Radiator::kMaxPoints each); the buffer is reused, so `consume`
    // must be done with it, or have submitted what reads it, when it returns.
    void generate(const SweptPatches& patches, const Consume& consume);
    // Makes the points of those patches that may have some in a box of voxels.
    void generateIn(const Box3& voxels, const SweptPatches& patches, const Consume& consume);

private:
    void generate(const SweptPatches& swept, const std::vector<SweptPatch>& all, std::size_t pointCount,
                  const Consume& consume);

    gl::Program program_;
    gl::Buffer corners_;
    gl::Buffer patches_;
    gl::Buffer points_;
};

} // namespace vs::sculpt
