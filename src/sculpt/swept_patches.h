// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vs::sculpt {

// A corner of a swept patch, as shaders see it (std430): it moves along start + depth * direction in voxel
// space.
struct SweptCorner {
    glm::vec4 start{0};     // xyz voxel space at depth 0, w mask value
    glm::vec4 direction{0}; // xyz voxels per unit of depth
};
static_assert(sizeof(SweptCorner) == 32);

// Four neighbouring elements of a mask and the solid they sweep, as shaders see it (std430).
struct SweptPatch {
    std::array<std::uint32_t, 4> corners{}; // (0,0) (1,0) (0,1) (1,1)
    std::uint32_t firstPoint = 0;           // among all points of its SweptPatches
    std::uint32_t counts = 0;               // samples along u (8 bits), v (8 bits) and depth (16 bits)
    float mask = -1;          // the same for the whole patch; bilinear between the corners' when negative
    std::uint32_t offset = 0; // of a single sample from the middle in u and v, as two 16-bit signed fractions
};
static_assert(sizeof(SweptPatch) == 32);

// A solid as the union of patches swept through a range of depths. Within a patch starts and directions are
// bilinear in (u, v), so P(u, v, d) = start(u, v) + d * direction(u, v) has no gaps between patches that
// share corners.
class SweptPatches {
public:
    // Samples are at most this many voxels apart. A quadratic deposit passes a lattice's ripple at frequency
    // f (per voxel) with sinc(f)^3 along each axis: zero at 1, 3e-3 at 1 / 1.15. Measured: density 1 within
    // 1e-2, in any direction.
    static constexpr float kSpacing = 1.15F;

    // A patch has at most this many samples.
    static constexpr int kMaxPatchPoints = 1 << 19;

    // `orientation` is the sign of det(dP/du, dP/dv, dP/dd) that counts as moving forwards: parts of a patch
    // that move the other way (paths that have crossed) carry no energy. 0: the sign that each patch has at
    // the depth closest to 0.
    SweptPatches(float depthLo, float depthHi, int orientation)
        : depthLo_(depthLo), depthHi_(depthHi), orientation_(orientation) {}

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

    [[nodiscard]] const std::vector<SweptCorner>& corners() const { return corners_; }
    [[nodiscard]] const std::vector<SweptPatch>& patches() const { return patches_; }
    [[nodiscard]] float depthLo() const { return depthLo_; }
    [[nodiscard]] float depthHi() const { return depthHi_; }
    [[nodiscard]] int orientation() const { return orientation_; }
    [[nodiscard]] std::size_t pointCount() const { return pointCount_; }
    // Voxels whose centres are nearest to the points: what Radiator::begin() wants.
    [[nodiscard]] Box3 pointBox() const;

private:
    void addPatch(const std::array<std::uint32_t, 4>& corners, float mean, glm::vec2 centroid,
                  bool isBilinear);

    std::vector<SweptCorner> corners_;
    std::vector<SweptPatch> patches_;
    glm::vec3 lo_{1e30F};
    glm::vec3 hi_{-1e30F};
    float depthLo_;
    float depthHi_;
    int orientation_;
    std::size_t pointCount_ = 0;
};

} // namespace vs::sculpt
