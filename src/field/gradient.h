// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "field/voxel_rows.h"

#include "gl/buffer.h"

#include <cstdint>
#include <vector>

namespace vs::field {

// Gradient magnitudes at voxel centres, in the volume's unit per mm: central differences over spacing along
// the patient's axes, as dataGradient() of field/shaders/scene.glsl has them; beyond the grid values are
// those at its border. Voxels that are, or touch, a non-finite one are left out everywhere. Ranges leave out
// what is steeper than field.usual can make it: the edges of fill values. Counted on the device, one pass
// over the voxels each.

// The gradient magnitudes from 0 to the 99.9th percentile (to about a hundredth of itself): what most of the
// volume needs.
Range gradientRange(const Field& field);
// The gradient magnitudes from 0 to the largest.
Range fullGradientRange(const Field& field);

// The magnitudes at all voxels, for shaders to look up between them: parts of `most`, as 16 bits; what is
// steeper counts as that. Zero at voxels that are left out.
struct GradientField {
    double most = 1;       // the volume's unit per mm
    gl::Texture texels;    // R16; empty where there are quads
    gl::TexelBuffer quads; // on software renderers (field/quads.h)
    gl::Texture cells;     // smallest and largest of each macrocell (field/cell_ranges.h), as parts of `most`
};
// `usual`: the end of gradientRange(); `most` becomes so much more that hardly anything is steeper. Throws
// GlError where the device has no room.
GradientField computeGradients(const Field& field, double usual);

// Counts of voxels in `bins` (at most 4096) equal bins over `gradients`. Magnitudes above it are left out.
std::vector<std::uint32_t> gradientHistogram(const Field& field, const Range& gradients, int bins = 256);

// Voxels by intensity and gradient magnitude, in equal bins.
struct JointHistogram {
    glm::ivec2 bins{0}; // along intensity and gradient magnitude; at most 4096 each, 2^24 in all
    Range values;       // of all voxels
    Range gradients;
    std::vector<std::uint32_t> counts; // intensity fastest
};

// Counts voxels by intensity and gradient magnitude. Magnitudes above `gradients` are left out.
JointHistogram jointHistogram(const Field& field, const Range& gradients, glm::ivec2 bins = {256, 256});

// The joint histogram over gradientRange(), counted in portions, so that a window can answer between them.
class JointCounting {
public:
    explicit JointCounting(const Field& field, glm::ivec2 bins = {256, 256});

    // Goes on for about `budgetMs`, or for one portion where that takes longer (tens of milliseconds on a
    // software renderer). True when all is counted.
    bool advance(double budgetMs);
    // Complete once advance() has said so.
    [[nodiscard]] const JointHistogram& joint() const { return joint_; }

private:
    const Field* field_;
    gl::Program measure_;
    gl::Program count_;
    gl::Buffer magnitudes_;
    gl::Buffer counts_;
    VoxelRows measured_;
    VoxelRows counted_;
    JointHistogram joint_;
};

} // namespace vs::field
