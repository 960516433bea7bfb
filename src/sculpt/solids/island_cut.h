// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/scene.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "sculpt/sculpture/sculpture.h"

namespace vs::sculpt {

// Cuts what is visible but does not belong to a region: the table below a patient (doc/behaviour.md,
// "Tools").
class IslandCutter {
public:
    // Cuts every voxel of `scene` that is in the displayed range, visible, and not in `region` (R8UI, 0 =
    // outside), and two voxels around each, so that nothing of their surface remains; but never within one
    // voxel of the region, whose surface stays as it is. Bricks are protected in `backup` before they change.
    // Returns the box that may have changed.
    Box3 cut(Sculpture& sculpture, const field::Scene& scene, const gl::Texture& region, BrickBackup& backup);

private:
    gl::ProgramVariants pack_{"sculpt/shaders/pack_islands.comp"};
    gl::ProgramVariants cut_{"sculpt/shaders/cut_islands.comp"}; // by the sculpture's defines()
    gl::Buffer islands_;                                         // one bit a voxel, 32 along x in a word
    gl::Buffer kept_;
    gl::Buffer bounds_;
    field::SceneBinding binding_;
};

} // namespace vs::sculpt
