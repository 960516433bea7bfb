// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/head_anatomy.h"
#include "phantom/scanner.h"

#include <cstdint>

namespace vs::phantom {

// What a made head is measured with.
struct HeadPhantomOptions {
    // Voxels along each axis. The head is the same at any resolution: the grid always covers 181 x 217 x 181
    // mm.
    glm::ivec3 dims{181, 217, 181};
    // Standard deviation of the noise in each of the two channels whose magnitude is taken (Rician noise), in
    // percent of white matter.
    double noisePercent = 0;
    // The sensitivity varies smoothly by this much over the brain, half of it above 1 and half below: 20
    // gives 0.9 to 1.1, as BrainWeb counts it.
    double biasPercent = 0;
    std::uint64_t seed = 1;
};

// A head as T1-weighted MR shows it (uint8, intensities of namespace t1): scalp with fat, skull with marrow,
// fluid, a folded cortex, ventricles. Voxels on borders hold the mean of what is in them. Always the same for
// the same options, however many threads make it.
LabelledVolume makeHeadPhantom(const HeadPhantomOptions& options);
// With a bias all voxels are looked at once to begin with.
Scanner headScanner(const HeadPhantomOptions& options);

} // namespace vs::phantom
