// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "field/scene.h"
#include "field/voxel_rows.h"

#include <cstdint>
#include <vector>

namespace vs::field {

// Counts of voxels in `bins` (at most 4096) equal bins over field.usual, counted on the device, or where that
// is a software renderer and the volume is at hand (Field::onHost), from the volume, many times sooner.
// Non-finite voxels and those outside are left out.
std::vector<std::uint32_t> intensityHistogram(const Field& field, int bins = 256);
// Counts a part of the voxels only, which must lie in the grid.
std::vector<std::uint32_t> intensityHistogram(const Field& field, const Box3& box, int bins);

// How many bins tell most of a field's values apart: one from each whole number to the next where that is
// possible, since bins of uneven size would comb.
int finestBins(const Field& field);

// Counts the voxels that a sculpture lets be seen in bins like those of intensityHistogram(), in portions, so
// that a window can answer between them.
class VisibleHistogram {
public:
    VisibleHistogram(const Field& field, int bins);

    // Begins anew; in a part of the voxels, which must lie in the grid.
    void start(SculptureView view);
    void start(SculptureView view, const Box3& box);
    // Goes on for about `budgetMs`, or for one portion where that takes longer (tens of milliseconds on a
    // software renderer). The sculpture must not have changed since start(). True when all is counted.
    bool advance(const gl::Texture& sculpture, double budgetMs);
    [[nodiscard]] std::vector<std::uint32_t> counts() const;

private:
    const Field* field_;
    int bins_;
    Box3 box_;
    SculptureView view_ = SculptureView::Cut;
    gl::Program program_;
    gl::Buffer counts_;
    VoxelRows rows_;
};

// The value below which the given part (0 to 1) of a histogram's voxels lies (equal bins over `range`), as if
// they were evenly spread within each bin.
double percentile(const std::vector<std::uint32_t>& histogram, const Range& range, double part);

// How many of a histogram's voxels lie in a range of values, taken so too.
double countWithin(const std::vector<std::uint32_t>& histogram, const Range& range, const Range& wanted);

// A displayed range that shows something sensible at first: from the threshold between background and object
// (volume::otsuThreshold) up to the largest value.
Range suggestRange(const std::vector<std::uint32_t>& histogram, const Range& range);

} // namespace vs::field
