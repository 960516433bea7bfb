// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace vs::sculpt {

// Paths are made in a space of steps: millimetres divided by the smallest spacing, which is voxel space on an
// isotropic grid. There frames are orthonormal, so a mask is swept undistorted in millimetres; sweepMask()
// scales to the voxels of the grid (voxelFromSteps()).

// Where a mask is and how it is turned: element (xi, eta) lies at origin + xi * x + eta * y (thesis, section
// 3.5.3, equation 3.7). x and y are unit vectors, and x cross y is the direction of the path.
struct MaskFrame {
    glm::dvec3 origin{0};
    glm::dvec3 x{1, 0, 0};
    glm::dvec3 y{0, 1, 0};

    [[nodiscard]] glm::dvec3 place(glm::dvec2 element) const {
        return origin + element.x * x + element.y * y;
    }
};

// A piece of a path: the mask moves in a straight line, or turns on the spot by a few degrees, from one frame
// to the next. Each piece of a path begins in the frame in which the one before ended.
struct PathPiece {
    MaskFrame from;
    MaskFrame to;
};

// Where a path matters, in the space of steps: its chords keep to the curve where they come within `reach` of
// the box. Farther away they are as long as their turn allows, so that a path costs what lies near the box.
struct PathRegion {
    glm::dvec3 lo{-std::numeric_limits<double>::infinity()};
    glm::dvec3 hi{std::numeric_limits<double>::infinity()};
    double reach = 0;

    // Whether anything within `radius` of a point may be where the path matters.
    [[nodiscard]] bool mayHold(const glm::dvec3& point, double radius) const;
};

// How the mask turns about the path. ParallelTransport: as little as it can (Bishop 1975, "There is more than
// one way to frame a curve"). Frenet: its x keeps to the line of the curve's principal normal (Frenet 1852);
// on straight parts, which have none, the last normal is kept (before the first bend, the first to come), and
// where the curve's bend changes sides, x does not jump over but stays on its side.
enum class FrameKind { ParallelTransport, Frenet };
inline constexpr std::array<const char*, 2> kFrameKinds{"parallel", "frenet"};
constexpr const auto& namesOf(FrameKind) { return kFrameKinds; }

// The frame of a mask at `origin` that faces `direction` (not zero): x along the first axis (x, else y) that
// is not along the direction, made perpendicular to it. A mask facing +z has x = +x and y = +y. Paths by
// parallel transport begin with it, and so do straight Frenet paths.
MaskFrame frameFacing(const glm::dvec3& origin, const glm::dvec3& direction);

// Straight lines from point to point; at a corner the mask turns on the spot about the axis across both
// lines. Points that coincide with the one before count once; fewer than two different ones give nothing. So
// it is with the other paths through points.
std::vector<PathPiece> polylinePath(std::span<const glm::dvec3> points,
                                    FrameKind kind = FrameKind::ParallelTransport);

// The centripetal Catmull-Rom spline through the points (Yuksel et al. 2011, "Parameterization and
// applications of Catmull-Rom curves"): smooth, without loops or cusps between points. Beyond its ends the
// curve is continued by the mirror images of the second and the last point but one. Chords turn by 0.05
// radians at most and stay within 0.01 steps of the curve in the region. Throws Error if that takes more than
// a quarter of a million chords.
std::vector<PathPiece> splinePath(std::span<const glm::dvec3> points,
                                  FrameKind kind = FrameKind::ParallelTransport,
                                  const PathRegion& region = {});

// A pen's way: many points, close together, noisy, some of them equal. They are taken at equal distances of
// one step, smoothed by a Gaussian of 2 steps along the way (both ends stay where they are), thinned to those
// that keep the way within 0.1 steps (Douglas and Peucker 1973) and joined by splinePath(). So tremble
// goes, and corners are rounded by about 1 step.
std::vector<PathPiece> recordedPath(std::span<const glm::dvec3> points,
                                    FrameKind kind = FrameKind::ParallelTransport,
                                    const PathRegion& region = {});

// A helix about the axis between two points, which are level with its ends. It starts beside `from` in the
// direction of frameFacing(from, to - from).x and turns right-handed, left-handed for negative `turns`.
struct Helix {
    glm::dvec3 from{0};
    glm::dvec3 to{0};
    double radius = 0;
    double turns = 1;

    // The point at t in [0, 1] of its height.
    [[nodiscard]] glm::dvec3 at(double t) const;
};

// The mask's origin runs on the helix and the mask stands across the curve. Frenet frames are the analytic
// ones, x towards the axis; parallel transport is by double reflection (Wang et al. 2008, "Computation of
// rotation minimizing frames"). Chords as in splinePath(). Nothing for a helix of no length.
std::vector<PathPiece> helixPath(const Helix& helix, FrameKind kind = FrameKind::ParallelTransport,
                                 const PathRegion& region = {});

} // namespace vs::sculpt
