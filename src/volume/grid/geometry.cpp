// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/geometry.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vs::volume {

glm::dvec3 GridGeometry::spacing() const {
    return {glm::length(glm::dvec3(worldFromVoxel[0])), glm::length(glm::dvec3(worldFromVoxel[1])),
            glm::length(glm::dvec3(worldFromVoxel[2]))};
}

double GridGeometry::stepMm() const {
    const auto s = spacing();
    return std::min({s.x, s.y, s.z});
}

glm::dmat4 GridGeometry::voxelFromWorld() const { return glm::inverse(worldFromVoxel); }

glm::dvec3 GridGeometry::centreWorld() const {
    return glm::dvec3(worldFromVoxel * glm::dvec4(0.5 * (glm::dvec3(dims) - 1.0), 1.0));
}

double GridGeometry::diagonalMm() const {
    double longest = 0;
    for (const glm::dvec3 signs : {glm::dvec3{1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}) {
        const glm::dvec3 diagonal = glm::dmat3(worldFromVoxel) * (signs * glm::dvec3(dims));
        longest = std::max(longest, glm::length(diagonal));
    }
    return longest;
}

double GridGeometry::voxelMm3() const { return std::abs(glm::determinant(glm::dmat3(worldFromVoxel))); }

std::size_t GridGeometry::voxelCount() const {
    return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z);
}

bool GridGeometry::isSheared() const {
    constexpr double tolerance = 1e-3;
    const auto m = glm::dmat3(worldFromVoxel);
    const auto cosine = [](glm::dvec3 a, glm::dvec3 b) {
        return std::abs(glm::dot(glm::normalize(a), glm::normalize(b)));
    };
    return std::max({cosine(m[0], m[1]), cosine(m[1], m[2]), cosine(m[2], m[0])}) > tolerance;
}

std::string GridGeometry::orientationCode() const {
    constexpr std::array<const char*, 3> letters{"RL", "AP", "IS"}; // negative, positive along L, P, S
    // Give each index axis the patient axis that it follows best, without using one twice.
    std::array<int, 3> patientAxis{-1, -1, -1};
    std::array<bool, 3> taken{};
    for (int round = 0; round < 3; ++round) {
        double best = -1;
        int bestIndex = 0;
        int bestPatient = 0;
        for (int i = 0; i < 3; ++i) {
            for (int p = 0; p < 3; ++p) {
                const double c = std::abs(worldFromVoxel[i][p]) / glm::length(glm::dvec3(worldFromVoxel[i]));
                if (patientAxis[std::size_t(i)] < 0 && !taken[std::size_t(p)] && c > best) {
                    best = c;
                    bestIndex = i;
                    bestPatient = p;
                }
            }
        }
        patientAxis[std::size_t(bestIndex)] = bestPatient;
        taken[std::size_t(bestPatient)] = true;
    }
    std::string code;
    for (int i = 0; i < 3; ++i) {
        const int p = patientAxis[std::size_t(i)];
        code += letters[std::size_t(p)][worldFromVoxel[i][p] >= 0 ? 1 : 0];
    }
    return code;
}

namespace {

constexpr std::array<std::string_view, 3> kSides{"RL", "AP", "IS"}; // negative, positive along L, P, S

// The patient axis (0 left, 1 posterior, 2 superior) that a letter is of, and which way it points there.
struct Side {
    int axis = -1; // none
    double sign = 1;
};
Side sideOf(char letter) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = kSides[std::size_t(axis)].find(letter);
        if (at != std::string_view::npos) {
            return {axis, at == 1 ? 1.0 : -1.0};
        }
    }
    return {};
}

GridGeometry aboutItsCentre(const GridGeometry& grid, const glm::dmat3& axes) {
    GridGeometry result{grid.dims, glm::dmat4(axes)};
    result.worldFromVoxel[3] =
        glm::dvec4(grid.centreWorld() - axes * (0.5 * (glm::dvec3(grid.dims) - 1.0)), 1.0);
    return result;
}

} // namespace

bool isOrientationCode(std::string_view code) {
    std::array<bool, 3> isTaken{};
    for (const char letter : code) {
        const Side side = sideOf(letter);
        if (side.axis < 0 || std::exchange(isTaken[std::size_t(side.axis)], true)) {
            return false;
        }
    }
    return code.size() == 3;
}

GridGeometry reoriented(const GridGeometry& grid, std::string_view code) {
    const std::string now = grid.orientationCode();
    if (code == now) {
        return grid;
    }
    const glm::dvec3 spacing = grid.spacing();
    glm::dmat3 axes(1);
    for (int i = 0; i < 3; ++i) {
        const Side wanted = sideOf(code[std::size_t(i)]);
        for (int j = 0; j < 3; ++j) {
            const Side there = sideOf(now[std::size_t(j)]);
            if (there.axis == wanted.axis) {
                axes[i] =
                    wanted.sign * there.sign * spacing[i] / spacing[j] * glm::dvec3(grid.worldFromVoxel[j]);
            }
        }
    }
    return aboutItsCentre(grid, axes);
}

GridGeometry respaced(const GridGeometry& grid, const glm::dvec3& spacingMm) {
    const glm::dvec3 now = grid.spacing();
    if (spacingMm == now) {
        return grid;
    }
    glm::dmat3 axes(grid.worldFromVoxel);
    for (int i = 0; i < 3; ++i) {
        axes[i] *= spacingMm[i] / now[i];
    }
    return aboutItsCentre(grid, axes);
}

bool areMirrored(const GridGeometry& a, const GridGeometry& b) {
    return glm::determinant(glm::dmat3(a.worldFromVoxel)) * glm::determinant(glm::dmat3(b.worldFromVoxel)) <
           0;
}

GridGeometry makeGeometry(glm::ivec3 dims, glm::dvec3 spacing) {
    return {dims, glm::scale(glm::dmat4(1.0), spacing)};
}

} // namespace vs::volume
