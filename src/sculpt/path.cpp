// SPDX-License-Identifier: Apache-2.0
#include "sculpt/path.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr double kTurn = 0.05; // radians of one turning piece: chords stay within 0.03 % of the arc

MaskFrame firstFrame(const glm::dvec3& origin, const glm::dvec3& tangent) {
    const glm::dvec3 axis = std::abs(tangent.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(axis - tangent * glm::dot(axis, tangent));
    return {origin, x, glm::cross(tangent, x)};
}

void appendTurn(std::vector<PathPiece>& pieces, MaskFrame& frame, const glm::dvec3& from,
                const glm::dvec3& to) {
    const double angle = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
    glm::dvec3 axis = glm::cross(from, to);
    if (angle < 1e-9) {
        return;
    }
    axis =
        glm::length(axis) < 1e-9 ? frame.y : glm::normalize(axis); // straight back: any axis across will do
    const int count = int(std::ceil(angle / kTurn));
    const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), angle / count, axis));
    for (int n = 0; n < count; ++n) {
        const MaskFrame next{frame.origin, rotation * frame.x, rotation * frame.y};
        pieces.push_back({frame, next});
        frame = next;
    }
}

} // namespace

std::vector<PathPiece> polylinePath(std::span<const glm::dvec3> points) {
    std::vector<PathPiece> pieces;
    MaskFrame frame;
    glm::dvec3 tangent(0);
    for (std::size_t n = 1; n < points.size(); ++n) {
        const glm::dvec3 start = pieces.empty() ? points.front() : frame.origin;
        const glm::dvec3 way = points[n] - start;
        if (glm::length(way) < 1e-9) {
            continue;
        }
        const glm::dvec3 next = glm::normalize(way);
        if (pieces.empty()) {
            frame = firstFrame(start, next);
        } else {
            appendTurn(pieces, frame, tangent, next);
        }
        tangent = next;
        const MaskFrame end{points[n], frame.x, frame.y};
        pieces.push_back({frame, end});
        frame = end;
    }
    return pieces;
}

} // namespace vs::sculpt
