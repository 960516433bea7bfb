// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/scanner.h"

namespace vs::phantom {

// What the body phantom's labels say.
enum class BodyTissue : std::uint8_t { Air, Soft, Bone, Lung };

// How a body is scanned: a grid over a cube of 400 mm.
struct BodyPhantomOptions {
    glm::ivec3 dims{512};
    double noisePercent = 0; // standard deviation in percent of 1000 HU
    std::uint64_t seed = 1;
};

// A chest from the loins to the chin as CT shows it (int16, Hounsfield units): skin, fat, muscle, ribs,
// spine, lungs. All air around it (-1000) is one region, which its skin bounds with the roughness of a real
// one; the lungs (-850) do not touch it. Borders inside one voxel are mixed as in the head.
LabelledVolume makeBodyPhantom(const BodyPhantomOptions& options);
Scanner bodyScanner(const BodyPhantomOptions& options);

} // namespace vs::phantom
