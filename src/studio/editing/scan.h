// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/detail.h"
#include "field/field.h"
#include "studio/editing/first_look.h"
#include "volume/grid/volume.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vs::studio {

// The volume that a document is about, on the host and on the device, and what its values suggest. Its values
// never change; where its voxels lie can be corrected. Needs a current OpenGL context.
struct Scan {
    explicit Scan(volume::Volume opened);
    Scan(const Scan&) = delete; // the field knows where the volume lies
    Scan& operator=(const Scan&) = delete;

    // Its voxels lie there: of the same dimensions. What was derived from the field is to be made anew.
    void lay(const volume::GridGeometry& geometry);

    volume::GridGeometry inFile; // as it was opened
    volume::Volume volume;
    field::Field field;
    std::shared_ptr<const volume::BrickSource> levels; // all of them, the finest first; null: not known
    std::unique_ptr<field::Detail> detail; // finer levels of it, which pictures show; null: there are none
    std::vector<std::uint32_t> histogram;  // voxel counts in equal bins over volume.usual, at most 256
    Range shown;                           // the displayed range to begin with
    FirstLook firstLook;                   // as the window shows it to begin with
    Range grey;                            // the values that cut faces show from black to white
    Range slices;                          // the values that slices show so, where nobody chose others
};

} // namespace vs::studio
