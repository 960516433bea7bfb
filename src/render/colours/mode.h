// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/names.h"

#include <array>

namespace vs::render {

// How values along a ray become a pixel.
enum class Mode { Surface, Mip, XRay, Overlay, Segment, Volume };
inline constexpr Mode kModes[] = {Mode::Surface, Mode::Mip,     Mode::XRay,
                                  Mode::Overlay, Mode::Segment, Mode::Volume};
inline constexpr std::array<const char*, 6> kModeNames{"surface", "mip",     "xray",
                                                       "overlay", "segment", "volume"};
constexpr const auto& namesOf(Mode) { return kModeNames; }
constexpr const char* name(Mode mode) { return nameOf(mode); }

} // namespace vs::render
