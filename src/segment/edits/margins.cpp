// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/margins.h"

#include "base/error.h"
#include "segment/edits/nearby.h"
#include "segment/edits/set_algebra.h"

#include <cmath>

namespace vs::segment {

void checkDistance(const volume::GridGeometry& geometry, double mm) {
    if (!(mm >= 0 && mm <= geometry.diagonalMm())) {
        throw Error(
            "a distance of {} mm cannot be used here; it must lie between 0 and {:.0f} mm, the volume's "
            "diagonal",
            mm, std::floor(geometry.diagonalMm()));
    }
}

namespace {

Box3 padded(const Box3& box, glm::ivec3 voxels) { return {box.lo - voxels, box.hi + voxels}; }

VoxelSet complement(VoxelSet set) {
    for (auto& value : set.inside) {
        value = value == 0 ? 1 : 0;
    }
    return set;
}

// Grown as far as `clip` goes, which need not be the grid.
VoxelSet grown(const VoxelSet& set, const volume::GridGeometry& geometry, double mm, const Box3& clip) {
    const Box3 tight = set.tightBox();
    if (tight.isEmpty()) {
        return {};
    }
    return nearby(set.within(vs::intersect(padded(tight, reachOf(geometry, mm)), clip)), geometry, mm)
        .tight();
}

VoxelSet shrunk(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    const Box3 tight = set.tightBox();
    if (tight.isEmpty()) {
        return {};
    }
    // What is nearest outside of the box lies in the layer around it, except where axes are sheared.
    const Box3 box = padded(tight, isSheared(geometry) ? glm::max(reachOf(geometry, mm), 1) : glm::ivec3(1));
    return complement(nearby(complement(set.within(box)), geometry, mm)).tight();
}

} // namespace

VoxelSet changeMargin(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    checkDistance(geometry, std::abs(mm));
    return mm < 0 ? shrunk(set, geometry, -mm) : grown(set, geometry, mm, geometry.box());
}

VoxelSet opening(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    checkDistance(geometry, mm);
    return grown(shrunk(set, geometry, mm), geometry, mm, geometry.box());
}

VoxelSet closing(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    checkDistance(geometry, mm);
    // Clipped only at the end: otherwise shrinking would take back more than growing gave at the grid's
    // border.
    const Box3 everything = padded(set.tightBox(), reachOf(geometry, mm));
    return shrunk(grown(set, geometry, mm, everything), geometry, mm).cropped(0, geometry.dims);
}

VoxelSet hollow(const VoxelSet& set, const volume::GridGeometry& geometry, double thicknessMm, Wall wall) {
    checkDistance(geometry, thicknessMm);
    switch (wall) {
    case Wall::Inside:
        return subtract(set, changeMargin(set, geometry, -thicknessMm));
    case Wall::Outside:
        return subtract(changeMargin(set, geometry, thicknessMm), set);
    case Wall::Centred:
        break;
    }
    return subtract(changeMargin(set, geometry, thicknessMm / 2),
                    changeMargin(set, geometry, -thicknessMm / 2));
}

} // namespace vs::segment
