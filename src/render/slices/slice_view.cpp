// SPDX-License-Identifier: Apache-2.0
#include "render/slices/slice_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vs::render {

namespace {

// What a kind's pictures have to the right, below and onwards (LPS).
struct Convention {
    glm::dvec3 right;
    glm::dvec3 down;
    glm::dvec3 onwards;
};
constexpr std::array<Convention, 3> kConventions{{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},   // axial: left, posterior; superior
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, // coronal: left, inferior; anterior
    {{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}}, // sagittal: posterior, inferior; right
}};

// Which voxel axis runs nearest to each of the patient's, each used once: the assignment with the greatest
// sum of cosines.
std::array<int, 3> voxelAxes(const volume::GridGeometry& grid) {
    std::array<int, 3> axes{0, 1, 2};
    std::array<int, 3> best = axes;
    double most = -1;
    do {
        double sum = 0;
        for (int i = 0; i < 3; ++i) {
            sum += std::abs(glm::normalize(glm::dvec3(grid.worldFromVoxel[axes[std::size_t(i)]]))[i]);
        }
        if (sum > most + 1e-9) {
            most = sum;
            best = axes;
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return best;
}

int axisOf(glm::dvec3 direction) { return direction.x != 0 ? 0 : direction.y != 0 ? 1 : 2; }

} // namespace

const char* name(SliceKind kind) {
    constexpr const char* names[] = {"axial", "coronal", "sagittal"};
    return names[static_cast<int>(kind)];
}

SliceGeometry::SliceGeometry(const volume::GridGeometry& grid, SliceKind kind)
    : grid_(grid), kind_(kind), centre_(grid.centreWorld()), voxelFromWorld_(grid.voxelFromWorld()) {
    const Convention& convention = kConventions[std::size_t(kind)];
    const auto axes = voxelAxes(grid);
    const auto voxelAxis = [&](glm::dvec3 direction) { return axes[std::size_t(axisOf(direction))]; };
    // Along a voxel axis, turned to the side that the convention asks for.
    const auto alongAxis = [&](int axis, glm::dvec3 wanted) {
        const glm::dvec3 along(grid.worldFromVoxel[axis]);
        return glm::dot(along, wanted) < 0 ? -along : along;
    };
    axis_ = voxelAxis(convention.onwards);
    acrossAxis_ = voxelAxis(convention.right);
    downAxis_ = voxelAxis(convention.down);
    right_ = glm::normalize(alongAxis(acrossAxis_, convention.right));
    const glm::dvec3 down = alongAxis(downAxis_, convention.down);
    down_ = glm::normalize(down - glm::dot(down, right_) * right_);
    const glm::dvec3 along(grid.worldFromVoxel[axis_]);
    onwards_ = glm::dot(along, convention.onwards) < 0 ? -1 : 1;
    normal_ = glm::normalize(glm::cross(right_, down_));
    normal_ = glm::dot(normal_, along) * onwards_ < 0 ? -normal_ : normal_;
    voxelsRight_ = glm::dmat3(voxelFromWorld_) * right_;
    voxelsDown_ = glm::dmat3(voxelFromWorld_) * down_;
    voxelsRight_[axis_] = voxelsDown_[axis_] = 0; // but for rounding they are
}

double SliceGeometry::positionMm(double index) const {
    glm::dvec4 voxel(0, 0, 0, 1);
    voxel[axis_] = index;
    return glm::dot(glm::dvec3(grid_.worldFromVoxel * voxel), normal_);
}

glm::dvec2 SliceGeometry::placeOf(glm::dvec3 voxel) const {
    const glm::dvec3 offset = glm::dvec3(grid_.worldFromVoxel * glm::dvec4(voxel, 1.0)) - centre_;
    return {glm::dot(offset, right_), glm::dot(offset, down_)};
}

glm::dvec3 SliceGeometry::voxelAt(glm::dvec2 place, double index) const {
    const glm::dvec3 start(voxelFromWorld_ * glm::dvec4(centre_, 1.0));
    const glm::dvec3 perNormal = glm::dmat3(voxelFromWorld_) * normal_;
    glm::dvec3 voxel = start + place.x * voxelsRight_ + place.y * voxelsDown_ +
                       (index - start[axis_]) / perNormal[axis_] * perNormal;
    voxel[axis_] = index;
    return voxel;
}

glm::dvec2 SliceGeometry::halfExtentMm() const {
    glm::dvec2 half(0);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 edge = glm::dvec3(grid_.worldFromVoxel[axis]) * (0.5 * grid_.dims[axis]);
        half += glm::dvec2(std::abs(glm::dot(edge, right_)), std::abs(glm::dot(edge, down_)));
    }
    return half;
}

std::string directionLetters(glm::dvec3 world) {
    constexpr double kLeaning = 0.2588; // sine of 15 degrees
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](int a, int b) { return std::abs(world[a]) > std::abs(world[b]); });
    std::string letters;
    for (const int axis : axes) {
        if (letters.empty() || std::abs(world[axis]) > kLeaning * glm::length(world)) {
            letters += (world[axis] < 0 ? "RAI" : "LPS")[axis];
        }
    }
    return letters;
}

SliceGeometry::Letters SliceGeometry::letters() const {
    return {directionLetters(-right_), directionLetters(right_), directionLetters(-down_),
            directionLetters(down_)};
}

double pixelMmToShowAll(const SliceGeometry& geometry, glm::ivec2 size) {
    constexpr double kRoom = 1.06;
    const glm::dvec2 whole = 2.0 * geometry.halfExtentMm() * kRoom;
    return std::max(whole.x / std::max(size.x, 1), whole.y / std::max(size.y, 1));
}

} // namespace vs::render
