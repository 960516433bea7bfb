// SPDX-License-Identifier: Apache-2.0
#include "phantom/recipe.h"

#include "base/error.h"
#include "base/names.h"
#include "phantom/abdomen_phantom.h"
#include "phantom/body_phantom.h"
#include "phantom/head_phantom.h"
#include "phantom/skull_phantom.h"
#include "phantom/vessels_phantom.h"

namespace vs::phantom {

namespace {

constexpr std::array kHeadTissues{"air", "scalp", "skull", "CSF", "grey", "white", "ventricles"};
constexpr std::array kBodyTissues{"air", "soft tissue", "bone", "lung"};
constexpr std::array kVesselTissues{"air", "tissue", "brain", "artery", "bright tissue"};
constexpr std::array kAbdomenTissues{"air",    "soft tissue", "spine",     "ribs",        "pelvis",  "femora",
                                     "artery", "stent",       "colon gas", "colon stool", "kidneys", "liver"};
constexpr std::array kSkullTissues{"air",      "soft tissue", "brain", "skull",
                                   "mandible", "vertebrae",   "teeth", "lower left first molar"};

constexpr const char* kWhiteMatter = "white matter";
constexpr const char* kThousandHu = "1000 HU";
constexpr const char* kArteries = "large arteries";

Scanner scanHead(const Recipe& recipe) {
    return headScanner({recipe.dims.value_or(HeadPhantomOptions{}.dims), recipe.noisePercent,
                        recipe.biasPercent, std::uint64_t(recipe.seed)});
}

// The others are alike: a grid, noise, and the noise's seed.
template <typename Options, Scanner (*scanner)(const Options&)>
Scanner scanWithNoise(const Recipe& recipe) {
    return scanner({recipe.dims.value_or(Options{}.dims), recipe.noisePercent, std::uint64_t(recipe.seed)});
}

const std::array<About, kKinds.size()> kAbout{
    About{"T1-weighted MR of a head, uint8", HeadPhantomOptions{}.dims, true, kWhiteMatter, kHeadTissues,
          scanHead},
    About{"CT of a chest, int16", BodyPhantomOptions{}.dims, false, kThousandHu, kBodyTissues,
          scanWithNoise<BodyPhantomOptions, bodyScanner>},
    About{"time-of-flight MR angiogram of a head, uint8", VesselsPhantomOptions{}.dims, false, kArteries,
          kVesselTissues, scanWithNoise<VesselsPhantomOptions, vesselsScanner>},
    About{"CT of an abdomen and pelvis, int16", AbdomenPhantomOptions{}.dims, false, kThousandHu,
          kAbdomenTissues, scanWithNoise<AbdomenPhantomOptions, abdomenScanner>},
    About{"CT of a head with teeth, int16", SkullPhantomOptions{}.dims, false, kThousandHu, kSkullTissues,
          scanWithNoise<SkullPhantomOptions, skullScanner>}};

} // namespace

const About& about(Kind kind) { return kAbout[std::size_t(kind)]; }

Scanner scannerOf(const Recipe& recipe) {
    const About& kind = about(recipe.kind);
    if (recipe.biasPercent > 0 && !kind.hasBias) {
        throw UsageError("bias {}: the phantom '{}' has none, being {}; leave it out", recipe.biasPercent,
                         nameOf(recipe.kind), kind.meaning);
    }
    return kind.scanner(recipe);
}

LabelledVolume make(const Recipe& recipe) { return scanAll(scannerOf(recipe)); }

} // namespace vs::phantom
