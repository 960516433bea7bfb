// SPDX-License-Identifier: Apache-2.0
#include "sculpt/path/curve_frames.h"

#include "base/error.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr double kSamePlace = 1e-9;
constexpr double kStraight = 1e-6; // curvature, per step: a radius of a million steps

glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& tangent) {
    return glm::normalize(v - tangent * glm::dot(v, tangent));
}

glm::dvec3 turned(const glm::dvec3& v, double angle, const glm::dvec3& axis) {
    return glm::dmat3(glm::rotate(glm::dmat4(1), angle, axis)) * v;
}

bool isCorner(const CurveSample& a, const CurveSample& b) {
    return glm::length(b.point - a.point) < kSamePlace;
}

// Axis and angle of the turn at a corner; straight back turns about `aside`.
struct Turn {
    double angle = 0;
    glm::dvec3 axis{0, 0, 1};
};
Turn turnBetween(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& aside) {
    const glm::dvec3 normal = glm::cross(from, to);
    const double sine = glm::length(normal);
    return {std::atan2(sine, glm::dot(from, to)), sine < 1e-9 ? aside : normal / sine};
}

// Carries a vector across the tangent of `a` to `b` with the least rotation: two reflections, or one turn at
// a corner.
glm::dvec3 transported(const glm::dvec3& x, const CurveSample& a, const CurveSample& b) {
    if (isCorner(a, b)) {
        const Turn turn = turnBetween(a.tangent, b.tangent, glm::cross(a.tangent, x));
        return across(turned(x, turn.angle, turn.axis), b.tangent);
    }
    const auto reflected = [](const glm::dvec3& v, const glm::dvec3& normal) {
        const double square = glm::dot(normal, normal);
        return square > 0 ? v - normal * (2 * glm::dot(normal, v) / square) : v;
    };
    const glm::dvec3 way = b.point - a.point;
    const glm::dvec3 middle = b.tangent - reflected(a.tangent, way);
    return across(reflected(reflected(x, way), middle), b.tangent);
}

bool isCurved(const CurveSample& sample) { return glm::length(sample.curvature) > kStraight; }

// The mask's x at the first sample.
glm::dvec3 firstX(std::span<const CurveSample> samples, FrameKind kind) {
    const auto bend = std::find_if(samples.begin(), samples.end(), isCurved);
    if (kind == FrameKind::ParallelTransport || bend == samples.end()) {
        return frameFacing(samples.front().point, samples.front().tangent).x;
    }
    glm::dvec3 x = across(bend->curvature, bend->tangent);
    for (auto n = std::size_t(bend - samples.begin()); n > 0; --n) {
        x = transported(x, samples[n], samples[n - 1]);
    }
    return x;
}

MaskFrame frameAt(const glm::dvec3& point, const glm::dvec3& tangent, const glm::dvec3& x) {
    return {point, x, glm::cross(tangent, x)};
}

// Turns on the spot about an axis.
void appendTurn(std::vector<PathPiece>& pieces, const MaskFrame& start, const Turn& turn) {
    const int count = int(std::ceil(std::abs(turn.angle) / kChordTurn - 1e-9));
    MaskFrame frame = start;
    for (int n = 1; n <= count; ++n) {
        const double angle = turn.angle * n / count;
        const MaskFrame next{start.origin, turned(start.x, angle, turn.axis),
                             turned(start.y, angle, turn.axis)};
        pieces.push_back({frame, next});
        frame = next;
    }
}

// The chord from `a` to `b`, in as many pieces as `twist` needs, the turn about the tangent that comes on top
// of the least one, which takes start.x to `carried`.
void appendChord(std::vector<PathPiece>& pieces, const MaskFrame& start, const CurveSample& a,
                 const CurveSample& b, const glm::dvec3& carried, double twist) {
    const int count = std::max(int(std::ceil(std::abs(twist) / kChordTurn)), 1);
    MaskFrame frame = start;
    for (int n = 1; n <= count; ++n) {
        const double t = double(n) / count;
        const glm::dvec3 tangent = glm::normalize(glm::mix(a.tangent, b.tangent, t));
        const glm::dvec3 x = turned(across(glm::mix(start.x, carried, t), tangent), twist * t, tangent);
        const MaskFrame next = frameAt(glm::mix(a.point, b.point, t), tangent, x);
        pieces.push_back({frame, next});
        frame = next;
    }
}

// The angle about `tangent` from the carried x to the line of the sample's principal normal, on the nearer
// side.
double twistToNormal(const glm::dvec3& carried, const CurveSample& sample) {
    const glm::dvec3 normal = across(sample.curvature, sample.tangent);
    const double cosine = glm::dot(carried, normal);
    const double sine = glm::dot(glm::cross(carried, normal), sample.tangent);
    return cosine < 0 ? std::atan2(-sine, -cosine) : std::atan2(sine, cosine);
}

} // namespace

MaskFrame frameFacing(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 tangent = glm::normalize(direction);
    const glm::dvec3 axis = std::abs(tangent.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return frameAt(origin, tangent, across(axis, tangent));
}

void append(std::vector<CurveSample>& samples, const CurveSample& sample) {
    if (samples.size() == kMostSamples) {
        throw Error(
            "a path of more than {} chords within the mask's reach of the volume; make the path shorter "
            "or the mask smaller",
            kMostSamples);
    }
    samples.push_back(sample);
}

std::vector<PathPiece> framesAlong(std::span<const CurveSample> samples, FrameKind kind) {
    std::vector<PathPiece> pieces;
    if (samples.size() < 2) {
        return pieces;
    }
    MaskFrame frame = frameAt(samples.front().point, samples.front().tangent, firstX(samples, kind));
    const auto arrive = [&] { frame = pieces.empty() ? frame : pieces.back().to; };
    for (std::size_t n = 1; n < samples.size(); ++n) {
        const CurveSample& a = samples[n - 1];
        const CurveSample& b = samples[n];
        const glm::dvec3 carried = transported(frame.x, a, b);
        const double twist = kind == FrameKind::Frenet && isCurved(b) ? twistToNormal(carried, b) : 0;
        if (isCorner(a, b)) {
            appendTurn(pieces, frame, turnBetween(a.tangent, b.tangent, frame.y));
            arrive();
            appendTurn(pieces, frame, {twist, b.tangent});
        } else {
            appendChord(pieces, frame, a, b, carried, twist);
        }
        arrive();
    }
    return pieces;
}

} // namespace vs::sculpt
