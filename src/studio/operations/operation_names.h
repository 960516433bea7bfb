// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <array>

namespace vs::studio {

// The texts that stand for enumerators in session files, in the enumerators' order.
inline constexpr std::array<const char*, 6> kShapes{"free-form", "ellipse",  "circle",
                                                    "rectangle", "polyline", "stencil"};
inline constexpr std::array<const char*, 3> kSculptureViews{"whole", "cut", "probe"};
inline constexpr std::array<const char*, 2> kSamplings{"linear", "cubic"};
inline constexpr std::array<const char*, 2> kProjections{"perspective", "orthographic"};
inline constexpr std::array<const char*, 6> kModes{"surface", "mip", "xray", "overlay", "segment", "volume"};

// The operations' names, in the order of the variant's alternatives.
inline constexpr std::array<const char*, std::variant_size_v<Operation>> kOperationNames{
    "view",           "peel",
    "drill",          "laser",
    "sweep",          "scissors",
    "clip",           "keep connected",
    "paste",          "move part",
    "seed",           "grow",
    "rewind",         "show generation",
    "growth rules",   "absorb",
    "segment",        "load labels",
    "remove segment", "edit segment",
    "brush segment",  "paint segment",
    "cut segment",    "undo",
    "redo",           "un-cut",
    "re-seed",        "picture",
    "labels",         "sculpture"};
inline constexpr std::array<const char*, 13> kSegmentEdits{
    "keep island", "drop island", "keep largest", "drop small", "fill holes", "margin",   "open",
    "close",       "smooth",      "hollow",       "unite",      "subtract",   "intersect"};
inline constexpr std::array<const char*, 6> kPathKinds{"surface", "view plane", "polyline",
                                                       "spline",  "helix",      "standing"};
inline constexpr std::array<const char*, 2> kFrames{"parallel", "frenet"};
inline constexpr std::array<const char*, 2> kMethods{"radiation", "projection"};
inline constexpr std::array<const char*, 2> kEnergies{"calibrated", "raw"};

} // namespace vs::studio
