// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/scanner.h"

namespace vs::phantom {

// What the vessels phantom's labels say. Artery is the tree of the carotids, the vertebral and the cerebral
// arteries; Bright is what shines like it and is none of it: veins and fat of the right cheek and temple.
enum class VesselsTissue : std::uint8_t { Air, Tissue, Brain, Artery, Bright };

// How a head's arteries are scanned. The grid always covers 180 x 210 x 150 mm.
struct VesselsPhantomOptions {
    glm::ivec3 dims{192, 224, 160};
    // Standard deviation of the noise in each of the two channels whose magnitude is taken (Rician noise), in
    // percent of the large arteries.
    double noisePercent = 0;
    std::uint64_t seed = 1;
};

// A head from the jaw to below the vertex as a time-of-flight MR angiogram shows it (uint8): tissue is dim
// (45 to 110), blood that flows in is bright (236 in large arteries, 205 in small ones). Both internal
// carotids with their siphons, vertebral and basilar arteries, the circle of Willis, and cerebral arteries
// that branch down to 1.2 mm, with a small aneurysm where the right middle cerebral artery divides. Below the
// skull a thin vein (152) leads from the right carotid to fat in the cheek (160) and a vein of the temple
// (166): growth by a wide range leaks through it. Borders inside one voxel are mixed as in the head.
LabelledVolume makeVesselsPhantom(const VesselsPhantomOptions& options);
Scanner vesselsScanner(const VesselsPhantomOptions& options);

} // namespace vs::phantom
