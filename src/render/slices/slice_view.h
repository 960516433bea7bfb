// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/geometry.h"

#include <array>
#include <string>

namespace vs::render {

// The three ways to slice a volume. A slice is one layer of voxels, across the voxel axis that runs nearest
// to the patient's: on an oblique scan the scan's own slices, which show its values as they are.
enum class SliceKind { Axial, Coronal, Sagittal };
inline constexpr std::array<SliceKind, 3> kSliceKinds{SliceKind::Axial, SliceKind::Coronal,
                                                      SliceKind::Sagittal};
// "axial", "coronal", "sagittal".
const char* name(SliceKind kind);

// How slices of one kind lie on their grid and in their pictures. Pictures follow the radiologists'
// convention: the patient's left is on the right of axial and coronal ones, the face looks to the left in
// sagittal ones, the head and on axial ones the face is on top.
//
// A place on a picture is in mm to the right and down from where the grid's centre appears; lengths and
// angles are the patient's own, also on anisotropic and sheared grids.
class SliceGeometry {
public:
    SliceGeometry(const volume::GridGeometry& grid, SliceKind kind);

    [[nodiscard]] SliceKind kind() const { return kind_; }
    // The voxel axis across the slices: they are counted along it.
    [[nodiscard]] int axis() const { return axis_; }
    [[nodiscard]] int count() const { return grid_.dims[axis_]; }
    // The other two voxel axes: the one that runs to the right or the left, the one that runs down or up.
    [[nodiscard]] int acrossAxis() const { return acrossAxis_; }
    [[nodiscard]] int downAxis() const { return downAxis_; }
    // 1 when the index rises towards the head, the face or the patient's right, else -1.
    [[nodiscard]] int onwards() const { return onwards_; }

    // Unit vectors of the picture in the world: to the right, down, and across, onwards.
    [[nodiscard]] glm::dvec3 right() const { return right_; }
    [[nodiscard]] glm::dvec3 down() const { return down_; }
    [[nodiscard]] glm::dvec3 normal() const { return normal_; }
    // Where a slice lies along its normal, in mm: on straight grids one of the world's coordinates.
    [[nodiscard]] double positionMm(double index) const;

    // The place on the picture at which a place in voxel space appears.
    [[nodiscard]] glm::dvec2 placeOf(glm::dvec3 voxel) const;
    // What is at a place of the slice with that index, in voxel space.
    [[nodiscard]] glm::dvec3 voxelAt(glm::dvec2 place, double index) const;
    // How far in voxel space one mm to the right and one mm down on the picture lead.
    [[nodiscard]] glm::dvec3 voxelsPerMmRight() const { return voxelsRight_; }
    [[nodiscard]] glm::dvec3 voxelsPerMmDown() const { return voxelsDown_; }
    // Half the width and height in mm of the grid's box as it appears, voxel borders included.
    [[nodiscard]] glm::dvec2 halfExtentMm() const;

    // The directions of the patient that the picture's edges face: "L", or on oblique grids "LA", the nearest
    // first.
    struct Letters {
        std::string left;
        std::string right;
        std::string top;
        std::string bottom;
    };
    [[nodiscard]] Letters letters() const;

private:
    volume::GridGeometry grid_;
    SliceKind kind_;
    int axis_ = 2;
    int acrossAxis_ = 0;
    int downAxis_ = 1;
    int onwards_ = 1;
    glm::dvec3 centre_{0}; // world
    glm::dvec3 right_{0};
    glm::dvec3 down_{0};
    glm::dvec3 normal_{0};
    glm::dmat4 voxelFromWorld_{1.0};
    glm::dvec3 voxelsRight_{0};
    glm::dvec3 voxelsDown_{0};
};

// The patient's direction nearest to a vector of the world (LPS), and after it the next ones that it leans to
// by more than 15 degrees: "L", "PS".
std::string directionLetters(glm::dvec3 world);

// Says which slice is looked at, and what part of it.
struct SliceView {
    SliceKind kind = SliceKind::Axial;
    int index = 0;
    glm::dvec2 centreMm{0}; // the place in the middle of the picture
    double pixelMm = 1;
    glm::ivec2 size{1}; // pixels

    // Leads from a place on the slice to pixels of the picture (y down, the first pixel's centre at 0.5,
    // 0.5), and back.
    [[nodiscard]] glm::dvec2 pixelOf(glm::dvec2 place) const {
        return (place - centreMm) / pixelMm + 0.5 * glm::dvec2(size);
    }
    [[nodiscard]] glm::dvec2 placeAt(glm::dvec2 pixel) const {
        return centreMm + (pixel - 0.5 * glm::dvec2(size)) * pixelMm;
    }

    bool operator==(const SliceView&) const = default;
};

// The size of a pixel, in mm, at which all of a slice is seen in a picture of that size, with a little room
// around it.
double pixelMmToShowAll(const SliceGeometry& geometry, glm::ivec2 size);

} // namespace vs::render
