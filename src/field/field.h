// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/non_finite.h"
#include "field/quads.h"
#include "gl/texture.h"
#include "volume/grid/volume.h"

#include <cstdint>

namespace vs::field {

// A volume's values on the device. 8- and 16-bit integers, scaled ones too, are unsigned-normalised texels,
// everything else 32-bit float; value = texel * valueScale + valueOffset in all cases, exact at voxel centres
// after rounding to whole numbers (isIntegral) or whole steps. Non-finite voxels hold kNonFinite, which no
// range contains.
struct Field {
    gl::Texture texels;
    gl::TexelBuffer quads;    // on software renderers: the same again, for faster sampling
    bool mayHaveQuads = true; // false: neither has anything that is derived from it, for want of memory
    volume::GridGeometry geometry;
    float valueScale = 1;
    float valueOffset = 0;
    bool isIntegral = false;   // stored values are whole numbers
    double step = 0;           // scaled values are whole steps of this size apart (field/whole_steps.h); or 0
    bool isHounsfield = false; // the values are said to be Hounsfield units
    Range range;               // smallest and largest finite value
    Range usual;               // volume::Volume::usual: of histograms, landmarks and tables
    // The volume that was uploaded, where its owner keeps it beside the field, as studio::Scan does: its
    // values on the host. Null: they can be read back.
    const volume::Volume* onHost = nullptr;
    std::uint64_t serial = 0; // different for each upload: whether what was derived from it is still good
};

// How far interpolated values that lie at `end` of a displayed range may be off by rounding, in the field's
// unit: what comparisons with it allow for, or the inside of an object of exactly that value would be seen as
// outside.
double toleranceAt(double end, const Field& field);
// A displayed range, wider by that at either end.
Range withTolerance(const Range& displayed, const Field& field);

// A serial number that no field has yet.
std::uint64_t nextSerial();

// Uploads a volume. Throws GlError if the device has no room.
Field uploadVolume(const volume::Volume& volume);

// Bricks of 32^3 voxels: the unit of dirty tracking, undo and summaries.
inline constexpr int kBrick = 32;

} // namespace vs::field
