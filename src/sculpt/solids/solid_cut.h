// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/program.h"
#include "gl/texture.h"
#include "sculpt/mask/mask.h"
#include "sculpt/sculpture/cut_target.h"
#include "volume/grid/geometry.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace vs::sculpt {

// The way from the world (mm) to a picture, as far as cutting along its rays needs to know it.
struct Projector {
    glm::dmat4 pixelFromWorld{1}; // (x w, y w, any, w): w is the distance along `forward`, 1 if orthographic
    glm::dvec3 eye{0};           // distances along rays are counted from here, or from the plane through here
    glm::dvec3 forward{0, 0, 1}; // unit
    double pixelMm = 1;          // width of a pixel in mm where w is 1
    bool isOrthographic = false;
    glm::ivec2 viewport{1};
};

// A closed stroke on the picture, extruded along the rays through it.
struct Extrusion {
    Outline outline; // pixels
    Projector projector;
    bool cutsOutside = false;
    // Where along its ray (mm; negative: nowhere) the solid begins and ends under the centre of each pixel of
    // the viewport, x fastest. Empty: through everything.
    std::span<const float> beginMm = {};
    std::span<const float> endMm = {};
    int radius = 3; // steps: the edge is as wide as that of radiation
};

// A convex solid: dot(plane.xyz, p) + plane.w <= 0 for all planes, p in the world, unit normals, mm.
struct HalfSpaces {
    std::vector<glm::dvec4> planes; // at most kMaxPlanes
    bool cutsInside = false;
    int radius = 3;
};

// Cuts solids whose shape is known exactly, voxel by voxel, with the edge that radiation would give a plane:
// the Gaussian's integral over the distance from the boundary. So the 0.5 level lies on the boundary, at any
// size, without any points. Where two boundaries meet, the smaller energy
// counts: corners stay sharp.
class SolidCutter {
public:
    static constexpr int kMaxPlanes = 32;

    explicit SolidCutter(const volume::GridGeometry& geometry) : geometry_(geometry) {}
    // From now on voxels lie there.
    void follow(const volume::GridGeometry& geometry) { geometry_ = geometry; }

    // Return the box that may have changed; outlines of fewer than three points and empty lists of planes
    // change nothing.
    Box3 extrude(CutTarget& target, const Extrusion& solid, Combine how);
    Box3 clip(CutTarget& target, const HalfSpaces& solid, Combine how);
    // Cuts a solid that is given by its energies, one for each voxel of the grid, x fastest. Returns the box
    // that may have changed.
    Box3 cutValues(CutTarget& target, std::span<const float> energies, Combine how);

private:
    // How much of a tile of 8^3 voxels a solid takes, judged by how deep (mm, negative outside) its centre
    // lies.
    using DepthOfTile = std::function<double(const glm::dvec3& centreWorld)>;
    struct Tiles {
        std::vector<std::uint32_t> partly; // by number in a grid of tiles, x fastest
        std::vector<std::uint32_t> wholly;
    };
    [[nodiscard]] double tileReach(int radius) const;
    [[nodiscard]] Tiles find(const Box3& box, int radius, const DepthOfTile& depth) const;
    // Binds what a program for tiles that are cut partly needs, and gives the program.
    using Prepare = std::function<gl::Program&(const CutTarget::Part&)>;
    Box3 run(const Prepare& prepare, Tiles tiles, CutTarget& target, int radius, Combine how);
    Box3 runIn(const CutTarget::Part& part, const Prepare& prepare, const Tiles& all, int radius,
               Combine how);
    void fillBricks(Tiles& tiles, CutTarget& target, Combine how) const;
    [[nodiscard]] Box3 boxOf(std::uint32_t tile) const;
    void dispatch(gl::Program& program, const std::vector<std::uint32_t>& tiles, glm::ivec3 firstVoxel,
                  int radius, Combine how);

    volume::GridGeometry geometry_;
    gl::Buffer list_;
    // By the sculpture's defines().
    gl::ProgramVariants fill_{"sculpt/shaders/cut_all.comp"};
    gl::ProgramVariants extrude_{"sculpt/shaders/cut_extrusion.comp"};
    gl::ProgramVariants clip_{"sculpt/shaders/cut_half_spaces.comp"};
    gl::ProgramVariants cutValues_{"sculpt/shaders/cut_values.comp"};
};

// Distances in pixels from an outline, positive inside (even-odd rule), clamped to +-band; element (i, j)
// lies at origin + (i, j). Outside the raster is -band.
struct OutlineDistances {
    glm::ivec2 size{0};
    glm::dvec2 origin{0};
    double band = 0;
    std::vector<float> values;
};
OutlineDistances outlineDistances(const Outline& outline, double band);

} // namespace vs::sculpt
