// SPDX-License-Identifier: Apache-2.0
#include "phantom/skull_teeth.h"

#include "phantom/head_shape.h"
#include "phantom/solid_distances.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vs::phantom {

namespace {

constexpr double kGapMm = 1.5;  // between neighbours
constexpr double kOpenMm = 1.4; // from the bite to either jaw's teeth
constexpr double kEnamelMm = 1.6;
constexpr int kTeeth = 8;      // a quadrant
constexpr int kFirstMolar = 5; // counted from 0
constexpr int kFirstPremolar = 3;
constexpr int kCanine = 2;

struct Form {
    double width; // along the arch
    double depth; // across it
    double crown; // height
    double root;  // length
};
constexpr std::array<Form, kTeeth> kUpper{{{7.4, 6.4, 9.6, 12.5},
                                           {5.8, 5.8, 8.8, 12.5},
                                           {6.6, 7.4, 9.6, 15},
                                           {6.2, 8.2, 8.2, 13},
                                           {6.0, 8.4, 7.6, 13},
                                           {9.3, 10.2, 7.2, 12.5},
                                           {8.9, 10, 6.8, 11.5},
                                           {8.0, 9.2, 6.2, 10}}};
constexpr std::array<Form, kTeeth> kLower{{{4.9, 5.6, 8.6, 11.5},
                                           {5.3, 5.8, 8.8, 12.5},
                                           {6.2, 7.2, 9.8, 15},
                                           {6.2, 7.2, 8.2, 13.5},
                                           {6.3, 7.6, 7.4, 13},
                                           {9.8, 9.4, 7.2, 13},
                                           {9.3, 9.2, 6.8, 12.5},
                                           {8.7, 8.8, 6.4, 10.5}}};

// Half an arch, seen from above: a quarter of an ellipse, and a straight piece behind it.
class Arch {
public:
    Arch(double halfWidth, double length, const std::array<Form, kTeeth>& forms) {
        constexpr int kPieces = 22;
        for (int i = 0; i <= kPieces; ++i) {
            const double angle = 0.5 * std::numbers::pi * i / kPieces;
            places_[std::size_t(i)] = {halfWidth * std::sin(angle), kBackY - length * std::cos(angle)};
        }
        places_[kPieces + 1] = places_[kPieces] + glm::dvec2(0.8, 8);
        places_[kPieces + 2] = places_[kPieces + 1] + glm::dvec2(0.8, 8);
        double along = 0.5 * kGapMm;
        for (std::size_t i = 0; i < kTeeth; ++i) {
            middles_[i] = along + 0.5 * forms[i].width;
            along += forms[i].width + kGapMm;
        }
    }
    [[nodiscard]] ArchPlace beside(glm::dvec2 p) const {
        ArchPlace nearest{.alongMm = 0, .distanceMm = 1e9};
        double start = 0;
        for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
            const glm::dvec2 edge = places_[i + 1] - places_[i];
            const double length = glm::length(edge);
            const double t = std::clamp(glm::dot(p - places_[i], edge) / (length * length), 0.0, 1.0);
            const double distance = glm::length(p - places_[i] - t * edge);
            if (distance < nearest.distanceMm) {
                nearest = {start + t * length, distance};
            }
            start += length;
        }
        return nearest;
    }
    // The tooth whose share of the arch a place lies beside.
    [[nodiscard]] std::size_t toothAt(double alongMm) const {
        std::size_t best = 0;
        for (std::size_t i = 0; i + 1 < kTeeth; ++i) {
            const double border = 0.5 * (middles_[i] + middles_[i + 1]);
            best = alongMm > border ? i + 1 : best;
        }
        return best;
    }
    // Coordinates about a tooth's middle: along the arch, and outwards from it.
    [[nodiscard]] glm::dvec2 aboutTooth(std::size_t tooth, glm::dvec2 p) const {
        double start = 0;
        for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
            const glm::dvec2 edge = places_[i + 1] - places_[i];
            const double length = glm::length(edge);
            if (middles_[tooth] < start + length || i + 2 == places_.size()) {
                const glm::dvec2 along = edge / length;
                const glm::dvec2 q = p - places_[i] - (middles_[tooth] - start) * along;
                return {glm::dot(q, along), q.x * along.y - q.y * along.x};
            }
            start += length;
        }
        return {};
    }

private:
    static constexpr double kBackY = -33;

    std::array<glm::dvec2, 25> places_;
    std::array<double, kTeeth> middles_{};
};

const Arch& archOf(Jaw jaw) {
    static const Arch kUpperArch(29.5, 53, kUpper);
    static const Arch kLowerArch(27.5, 50, kLower);
    return jaw == Jaw::Upper ? kUpperArch : kLowerArch;
}

double rectangleDistance(glm::dvec2 p, glm::dvec2 half, double round) {
    const glm::dvec2 q = glm::abs(p) - half + round;
    return glm::length(glm::max(q, 0.0)) + std::min(std::max(q.x, q.y), 0.0) - round;
}

double squaredSine(double x) { return 0.5 - 0.5 * std::cos(2 * x); }

// One tooth in coordinates of its own: x along the arch, y outwards, z from its neck to its biting end.
class Shape {
public:
    Shape(int index, const Form& form) : index_(index), form_(form) {}

    [[nodiscard]] double crown(glm::dvec3 q) const {
        const double t = std::clamp(q.z / form_.crown, 0.0, 1.0);
        glm::dvec2 half = 0.5 * glm::dvec2(form_.width, form_.depth);
        half.x *= glm::mix(0.8, 1.0, glm::smoothstep(0.0, 0.5, t));
        if (index_ < kFirstPremolar) { // they cut
            half.y = glm::mix(0.95 * half.y, index_ == kCanine ? 2.0 : 1.5, glm::smoothstep(0.1, 1.0, t));
            half.x *= index_ == kCanine ? 1 - 0.3 * glm::smoothstep(0.55, 1.0, t) : 1.0;
        } else { // they grind
            half.y *=
                glm::mix(0.84, 1.0, glm::smoothstep(0.0, 0.4, t)) * (1 - 0.2 * glm::smoothstep(0.6, 1.0, t));
        }
        const double side = rectangleDistance({q.x, q.y}, half, 0.62 * std::min(half.x, half.y));
        return smoothMax(smoothMax(side, q.z - top(q), 1.4), -0.4 - q.z, 0.8);
    }
    [[nodiscard]] double root(glm::dvec3 q) const {
        const double w = form_.width;
        const double flat = w / form_.depth; // roots are as much deeper than wide as the crown
        if (index_ < kFirstMolar) {
            const double slant = 0.05 * form_.root;
            return coneDistance({q.x, 0.92 * flat * q.y, q.z}, {0, 0, 0.4}, 0.37 * w,
                                {slant, 0, 1.1 - form_.root}, 1.1);
        }
        const double trunk =
            coneDistance({q.x, flat * q.y, q.z}, {0, 0, 0.8}, 0.38 * w, {0, 0, -1.6}, 0.34 * w);
        return smoothMin(trunk, std::min(branch(q, -1), branch(q, 1)), 1.2);
    }
    // The canals are finer than a voxel: they end with a radius below 0, where they only darken it.
    [[nodiscard]] double pulp(glm::dvec3 q) const {
        const double end = -0.6 * form_.root;
        if (index_ < kFirstMolar) {
            return coneDistance(q, {0, 0, 0.4 * form_.crown}, 0.12 * form_.width, {0.03 * form_.root, 0, end},
                                -0.8);
        }
        const double room =
            ellipsoidDistance(q - glm::dvec3(0, 0, 0.8), {0.2 * form_.width, 0.18 * form_.depth, 1.3});
        const auto canal = [&](double side) {
            return coneDistance(q, {side * 0.14 * form_.width, 0, 0.6}, 0.5,
                                {side * 0.24 * form_.width, 0, end}, -0.8);
        };
        return std::min(room, std::min(canal(-1), canal(1)));
    }

private:
    // How high the biting end is: cusps with grooves between.
    [[nodiscard]] double top(glm::dvec3 q) const {
        const double across = squaredSine(2 * std::numbers::pi * q.y / form_.depth);
        if (index_ >= kFirstMolar) {
            return form_.crown - 1.7 * (1 - squaredSine(2 * std::numbers::pi * q.x / form_.width) * across);
        }
        if (index_ >= kFirstPremolar) {
            return form_.crown - 1.5 * (1 - across);
        }
        return form_.crown - (index_ == kCanine ? 0.55 * std::abs(q.x) : 0.0);
    }
    [[nodiscard]] double branch(glm::dvec3 q, double side) const {
        const double w = form_.width;
        return coneDistance({q.x, 0.58 * q.y, q.z}, {side * 0.21 * w, 0, -1}, 0.17 * w,
                            {side * 0.25 * w + 0.4, 0, 1 - form_.root}, 1.05);
    }

    int index_;
    const Form& form_;
};

} // namespace

ArchPlace besideArch(Jaw jaw, glm::dvec3 p) { return archOf(jaw).beside({std::abs(p.x), p.y}); }

Tooth toothNear(glm::dvec3 p) {
    Tooth tooth;
    if (std::abs(p.x) > 40 || p.y < -95 || p.y > -10 || std::abs(p.z - kBiteZ) > 30) {
        return tooth;
    }
    const Jaw jaw = p.z > kBiteZ ? Jaw::Upper : Jaw::Lower;
    const Arch& arch = archOf(jaw);
    const glm::dvec2 plan(std::abs(p.x), p.y);
    const ArchPlace place = arch.beside(plan);
    constexpr double kFarMm = 9;
    if (place.distanceMm > kFarMm) {
        return tooth;
    }
    const std::size_t index = arch.toothAt(place.alongMm);
    const Form& form = (jaw == Jaw::Upper ? kUpper : kLower)[index];
    const double fromBite = (jaw == Jaw::Upper ? p.z - kBiteZ : kBiteZ - p.z) - kOpenMm;
    const glm::dvec2 about = arch.aboutTooth(index, plan);
    // No tooth stands quite as its neighbour, or as the one on the other side.
    const double own = double(index) + (p.x > 0 ? 0.0 : 11.0) + (jaw == Jaw::Upper ? 5.0 : 0.0);
    const double lean = 0.04 * std::sin(2.3 * own) + (index < kFirstPremolar ? 0.1 : 0.0);
    const double up = form.crown - fromBite + 0.35 * std::sin(3.7 * own);
    const Shape shape(int(index), form);
    const glm::dvec3 q(about.x, about.y + 0.3 * std::sin(1.9 * own) - lean * up, up);
    tooth.number = int(index) + 1;
    tooth.crown = shape.crown(q);
    tooth.root = shape.root(q);
    tooth.dentine = std::min(tooth.crown + kEnamelMm, std::max(tooth.root, q.z - 0.2));
    tooth.pulp = shape.pulp(q);
    return tooth;
}

} // namespace vs::phantom
