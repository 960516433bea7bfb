// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace vs::sculpt {

// A corner of a swept patch, as shaders see it (std430): it moves along start + depth * direction in voxel
// space.
struct SweptCorner {
    glm::vec4 start{0};     // xyz voxel space at depth 0, w mask value
    glm::vec4 direction{0}; // xyz voxels per unit of depth
};
static_assert(sizeof(SweptCorner) == 32);

// Four neighbouring elements of a mask and a piece of the solid they sweep, as shaders see it (std430).
struct SweptPatch {
    std::array<std::uint32_t, 4> corners{}; // (0,0) (1,0) (0,1) (1,1)
    std::uint32_t firstPoint = 0;           // among all points of its SweptPatches
    std::uint32_t counts = 0;               // samples along u (8 bits), v (8 bits) and depth (16 bits)
    float mask = -1;          // one value for the whole patch; bilinear between the corners' when negative
    std::uint32_t offset = 0; // of a single sample from the middle in u and v, as two 16-bit signed fractions
    float depthLo = 0;
    float depthHi = 0;
};
static_assert(sizeof(SweptPatch) == 40);

// A solid as the union of patches swept through a range of depths. Within a patch starts and directions are
// bilinear in (u, v), so P(u, v, d) = start(u, v) + d * direction(u, v) has no gaps between patches that
// share corners. What lies far outside the grid, and what carries no energy because its paths have crossed,
// is left out; what needs too many samples is split. So samples are never too far apart, and their number
// follows what is swept inside the grid, however deep the sweep.
class SweptPatches {
public:
    // Samples are at most this many voxels apart. A quadratic deposit passes a lattice's ripple at frequency
    // f (per voxel) with sinc(f)^3 along each axis: zero at 1, 3e-3 at 1 / 1.15. Measured: density 1 within
    // 1e-2, in any direction.
    static constexpr float kSpacing = 1.15F;

    // A patch has at most this many samples; more make several patches.
    static constexpr int kMaxPatchPoints = 1 << 12;

    // `orientation` is the sign of det(dP/du, dP/dv, dP/dd) that counts as moving forwards: parts of a patch
    // that move the other way (paths that have crossed) carry no energy. 0: the sign that each patch has at
    // the depth closest to 0, and from there a path ends for good where it meets its neighbours.
    SweptPatches(float depthLo, float depthHi, int orientation)
        : depthLo_(depthLo), depthHi_(depthHi), orientation_(orientation) {}

    // Leaves out, from now on, what does not reach between these corners, in voxel space.
    void clipTo(const glm::vec3& lo, const glm::vec3& hi) {
        clipLo_ = lo;
        clipHi_ = hi;
    }

    // How much closer together samples must be along an axis on which the radiation spreads them over
    // `sigmaVoxels`: the narrow footprints of coarse slices (linear, and quadratic sharpened) smooth a
    // lattice less.
    static float densityFor(double sigmaVoxels) {
        return sigmaVoxels < 0.46 ? 6.0F : (sigmaVoxels < 0.6 ? 2.0F : 1.0F);
    }
    void setDensity(const glm::vec3& perAxis) { density_ = perAxis; }

    // Returns the new corner's index.
    std::uint32_t addCorner(const glm::vec3& start, const glm::vec3& direction, float mask);
    // Adds a patch between four neighbouring elements, choosing its number of samples; their masks are the
    // corners'. A single sample lies at the centre of mass of the four, so that nothing is blurred by joining
    // them.
    void addCell(const std::array<std::uint32_t, 4>& corners);
    // Adds a patch that stands for many elements, of mean `mask` and with their centre of mass at `centroid`
    // in (u, v).
    void addBlock(const std::array<std::uint32_t, 4>& corners, float mask, glm::vec2 centroid);
    void reserve(std::size_t corners, std::size_t patches);

    // Only notes what is added from now on; sweepPiece() makes the patches.
    void sweepInPieces() { inPieces_ = true; }
    // The patches become those of everything added, between these depths of the whole sweep. A piece's
    // samples do not depend on other pieces: whoever adds up adjoining ones has the whole, and can take one
    // away again.
    void sweepPiece(float depthLo, float depthHi);

    // A box that holds the points of any piece between these depths, as pointBox() says it; quick, and for
    // deep pieces larger than need be.
    [[nodiscard]] Box3 hullBox(float depthLo, float depthHi) const;

    [[nodiscard]] const std::vector<SweptCorner>& corners() const { return corners_; }
    [[nodiscard]] const std::vector<SweptPatch>& patches() const { return patches_; }
    [[nodiscard]] float depthLo() const { return depthLo_; }
    [[nodiscard]] float depthHi() const { return depthHi_; }
    [[nodiscard]] int orientation() const { return orientation_; }
    [[nodiscard]] std::size_t pointCount() const { return pointCount_; }
    // Voxels whose centres are nearest to the points: what Radiator::begin() wants.
    [[nodiscard]] Box3 pointBox() const;
    // The patches that may have points in a box of voxels, as a list of their own.
    struct Some {
        std::vector<SweptPatch> patches;
        std::size_t pointCount = 0;
    };
    [[nodiscard]] Some patchesIn(const Box3& voxels) const;

private:
    struct Interval {
        float lo = 0;
        float hi = 0;
    };
    // A part of a patch on its way to become one or more of patches_.
    struct Part {
        std::array<std::uint32_t, 4> corners{};
        Interval depths;
        float mean = 0; // of the mask
        glm::vec2 centroid{0.5F};
        bool isBilinear = false; // the mask; else it is the mean everywhere
        int level = 0;           // how often it has been split
    };
    using Quad = std::array<SweptCorner, 4>;

    [[nodiscard]] Quad quad(const std::array<std::uint32_t, 4>& corners) const;
    // The depths at which any of a part may reach the box and carry energy; nothing when there are none.
    [[nodiscard]] std::optional<Interval> usefulDepths(const Quad& quad, Interval depths) const;
    [[nodiscard]] std::optional<Interval> clipped(const Quad& quad, Interval depths) const;
    [[nodiscard]] Interval beforeCrossing(const Quad& quad, Interval depths) const;
    void add(const Part& part);
    [[nodiscard]] static Box3 voxelsBetween(const glm::vec3& lo, const glm::vec3& hi);
    void addPart(Part part);
    void splitAlongDepth(const Part& part);
    void splitAcross(const Part& part, int axis);

    std::vector<SweptCorner> corners_;
    std::vector<SweptPatch> patches_;
    glm::vec3 lo_{1e30F};
    glm::vec3 hi_{-1e30F};
    glm::vec3 clipLo_{-1e30F};
    glm::vec3 clipHi_{1e30F};
    glm::vec3 density_{1}; // voxels along an axis count this many times
    float depthLo_;
    float depthHi_;
    int orientation_;
    std::size_t pointCount_ = 0;
    bool inPieces_ = false;
    std::vector<Part> noted_;    // what was added, while sweeping in pieces
    std::size_t ownCorners_ = 0; // of those: later ones come from splitting
};

} // namespace vs::sculpt
