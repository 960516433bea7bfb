// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/scanner.h"

namespace vs::phantom {

// What the abdomen phantom's labels say. Soft is skin, fat, muscle, and all organs that are not named; Artery
// the room for blood in the aorta and what leaves it.
enum class AbdomenTissue : std::uint8_t {
    Air,
    Soft,
    Spine,
    Ribs,
    Pelvis,
    Femora,
    Artery,
    Stent,
    ColonGas,
    ColonStool,
    Kidneys,
    Liver
};

// How an abdomen is scanned. The grid always covers 400 x 320 x 460 mm.
struct AbdomenPhantomOptions {
    glm::ivec3 dims{192, 160, 224};
    double noisePercent = 0; // standard deviation in percent of 1000 HU
    std::uint64_t seed = 1;
};

// A body from the lower ribs to the thighs as CT shows it (int16, Hounsfield units), lying on its back, with
// contrast in the arteries (300) and kidneys (165), a stent graft (2400) in the lower aorta and both common
// iliac arteries, and a colon that holds gas (-900; the air around the body is -1000) above tagged stool
// (250). Bones are 720 outside and 430 inside. In the left groin a plaque (300) joins the artery to the
// pelvis, so that growth leaks from one into the other. Borders inside one voxel are mixed as in the head.
LabelledVolume makeAbdomenPhantom(const AbdomenPhantomOptions& options);
Scanner abdomenScanner(const AbdomenPhantomOptions& options);

} // namespace vs::phantom
