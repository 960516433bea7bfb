// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/scanner.h"

namespace vs::phantom {

// What the skull phantom's labels say. FirstMolar is the lower left one alone, Tooth all others.
enum class SkullTissue : std::uint8_t { Air, Soft, Brain, Skull, Mandible, Vertebrae, Tooth, FirstMolar };

// How a skull is scanned. The grid always covers 170 x 220 x 224 mm.
struct SkullPhantomOptions {
    glm::ivec3 dims{192, 224, 224};
    double noisePercent = 0; // standard deviation in percent of 1000 HU
    std::uint64_t seed = 1;
};

// A head with its neck as CT shows it (int16, Hounsfield units): skin, fat, muscle, brain, a skull with
// orbits, cheek bones and air in nose and sinuses, a lower jaw, five vertebrae, and 32 teeth of enamel
// (2500), dentine (1600) and pulp (100). Each tooth stands 1.5 mm from its neighbours, and its root in a
// socket of the jaw (900) from which a gap of 1.5 mm (150) parts it. Borders inside one voxel are mixed as in
// the head.
LabelledVolume makeSkullPhantom(const SkullPhantomOptions& options);
Scanner skullScanner(const SkullPhantomOptions& options);

} // namespace vs::phantom
