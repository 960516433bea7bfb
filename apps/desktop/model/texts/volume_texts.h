// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <QString>

#include <vector>

namespace vs::desktop {

// One thing that a volume is, in the person's language.
struct Property {
    const char* key; // for scripts
    QString name;
    QString text;
};

// What a person wants to know of a volume: where it comes from, where it lies (`grid`, by its file `inFile`),
// what its values are. What its files do not say is left out.
std::vector<Property> propertiesOf(const volume::Volume& volume, const volume::GridGeometry& grid,
                                   const volume::GridGeometry& inFile);

// "1 × 1 × 1.2 mm, LPS"
QString placeText(const volume::GridGeometry& grid);
// Says what of the patient is exchanged between two grids of which one is the other's mirror image.
QString mirroredText(const volume::GridGeometry& one, const volume::GridGeometry& other);

// "3–5, 9" for the slices 2, 3, 4 and 8, which are in order: people count them from 1.
QString runsOf(const std::vector<int>& numbers);

} // namespace vs::desktop
