// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/mask/mask.h"
#include "sculpt/path/path.h"
#include "sculpt/radiation/footprint.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// The texts of `vstudio sweep` as values. Each throws UsageError naming the text and what would be right.

// "NX,NY,NZ", each a whole number from 1 to 2048.
glm::ivec3 parseDims(const std::string& text);
// "SX,SY,SZ" in mm, each above 0.
glm::dvec3 parseSpacing(const std::string& text);

// How outlines become masks.
struct MaskMaking {
    double pitch = 0.5; // steps
    sculpt::MaskFilter filter;
    std::optional<sculpt::Subdivision> subdivision;
    int levels = 0;
};
// "SAMPLING[,RECONSTRUCTION[,WIDTH]]".
sculpt::MaskFilter parseFilter(const std::string& text);
// "SCHEME:LEVELS" into `making`.
void parseSubdivision(const std::string& text, MaskMaking& making);
// "SHAPE:SIZES", in steps.
sculpt::MaskRaster parseMask(const std::string& text, const MaskMaking& making);
inline constexpr const char* kMaskForms = "ellipse:RX,RY, circle:R, rectangle:WIDTH,HEIGHT, square:SIDE, "
                                          "star:OUTER,INNER,POINTS, polyline:X,Y:X,Y:X,Y... or "
                                          "image:FILE.png,WIDTH";

// Where a mask goes, in the space of steps: along pieces, or to one place where it stands.
struct SweepPath {
    std::vector<sculpt::PathPiece> pieces;
    std::optional<sculpt::MaskFrame> standing;
};
// "KIND:PLACES", places in voxels; `spacing` of the grid, which the mask comes into in `region`.
SweepPath parseSweepPath(const std::string& text, sculpt::FrameKind kind, const glm::dvec3& spacing,
                         const sculpt::PathRegion& region);
inline constexpr const char* kPathForms =
    "line:X,Y,Z:X,Y,Z, polyline:X,Y,Z:X,Y,Z:X,Y,Z..., spline:X,Y,Z:X,Y,Z:X,Y,Z..., "
    "helix:X,Y,Z:X,Y,Z:RADIUS,TURNS, recorded:FILE or at:X,Y,Z:DX,DY,DZ";

// "gaussian", "cube" or "ellipsoid:SX,SY,SZ".
sculpt::FootprintShape parseFootprint(const std::string& text, int radius);

// "HEAD:REST" in two; REST is empty without a colon.
struct Parted {
    std::string head;
    std::string rest;
};
Parted partAtColon(const std::string& text);

// The place of `text` among names such as kPrecisions; `option` begins the complaint.
std::size_t chooseName(const std::string& text, const char* const* names, std::size_t count,
                       const std::string& option);
template <typename Enum, std::size_t N>
Enum choose(const std::string& text, const std::array<const char*, N>& names, const std::string& option) {
    return Enum(chooseName(text, names.data(), N, option));
}

} // namespace vs::cli
