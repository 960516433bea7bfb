// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/connected_voxels.h"
#include "segment/measures/curve.h"
#include "volume/grid/geometry.h"

#include <array>

namespace vs::segment {

// The inside of a vessel, asked in the world (mm): what belongs to it is what lies in its voxels.
struct Lumen {
    const ConnectedVoxels& voxels;
    glm::dmat4 worldFromVoxel{1};
    glm::dmat4 voxelFromWorld{1};
    glm::ivec3 gridDims{0};
    double stepMm = 1;   // the smallest spacing
    double coarseMm = 1; // the largest spacing

    Lumen(const ConnectedVoxels& piece, const volume::GridGeometry& geometry);
    [[nodiscard]] int coarseAxis() const; // the index axis of the largest spacing
    [[nodiscard]] bool contains(const glm::dvec3& place) const;
    // How far two voxels that are neighbours along an index axis lie apart in a direction (unit), at most:
    // how finely the grid can tell where a surface lies that faces there.
    [[nodiscard]] double apartMm(const glm::dvec3& direction) const;
};

// How far it is from a place to the first one outside in a direction (unit), or `reachMm`.
double wallMm(const Lumen& lumen, const glm::dvec3& place, const glm::dvec3& direction, double reachMm);

inline constexpr std::size_t kRays = 32;

// The direction (unit) of a ray from a station: cos a across + sin a up, a = 2 pi ray / kRays.
glm::dvec3 rayOf(const Station& station, std::size_t ray);

// What is seen of the wall from a point of the axis, in the plane across it, ray by ray.
struct Outline {
    std::array<double, kRays> radiiMm{}; // up to the first place outside
    std::array<bool, kRays> isOpen{};    // no wall was met where it was to be expected: a branch goes off
    double typicalMm = 0;                // the median of the radii
    glm::dvec2 middleMm{0};              // centroid of the area, along across and up
};

// Whether a station is known to be in the middle of the vessel, so that what bulges out on one side only is a
// branch; flat vessels bulge out on both.
enum class Where { NearTheMiddle, InTheMiddle };

// Looks around. Rays that go on beyond `reachMm`, or leap beyond what most others say, are open; the radii
// there are those of the neighbours, so that they say where the wall would be.
Outline outlineAround(const Lumen& lumen, const Station& station, double reachMm,
                      Where where = Where::NearTheMiddle);

} // namespace vs::segment
