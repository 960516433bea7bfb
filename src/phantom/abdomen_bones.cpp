// SPDX-License-Identifier: Apache-2.0
#include "phantom/abdomen_bones.h"

#include "phantom/curved_plate.h"
#include "phantom/solid_distances.h"

#include <cmath>

namespace vs::phantom {

namespace {

constexpr double kFar = 40; // a bound for what is not near

constexpr glm::dvec3 kHip(88, 5, -140);
constexpr double kHeadMm = 22;   // radius of a femur's head
constexpr double kSocketMm = 26; // and of the socket that it turns in

glm::dvec3 leftOf(glm::dvec3 p) { return {std::abs(p.x), p.y, p.z}; }

// The slope of spineDepth.
double spineTilt(double z) { return z > 25 ? 0.0018 * (z - 25) : 0.0034 * (z - 25); }

// Processes of a vertebra, in coordinates about the middle of its body.
double vertebralArch(glm::dvec3 q, double lumbar) {
    const glm::dvec3 m = leftOf(q);
    const double pedicle = coneDistance(m, {11, 13, 5}, 5.5, {15, 25, 5}, 4.5);
    const double lamina = coneDistance(m, {14, 29, 1}, 4.5, {1, 38, -6}, 4);
    const double spinous = smoothMax(
        ellipsoidDistance(q - glm::dvec3(0, 46, -9), {5, 16, glm::mix(7.0, 11.0, lumbar)}), m.x - 3.2, 3);
    const double side =
        coneDistance(m, {15, 27, 4}, 4, {glm::mix(30.0, 41.0, lumbar), glm::mix(36.0, 31.0, lumbar), 6}, 3.4);
    const double above = coneDistance(m, {15, 29, 2}, 4.5, {15.5, 31, 17}, 4);
    const double below = coneDistance(m, {14, 31, -2}, 4.5, {14, 33, -17}, 4);
    return smoothMin(smoothMin(smoothMin(pedicle, lamina, 5), smoothMin(above, below, 4), 4),
                     smoothMin(spinous, side, 2), 5);
}

CurvedPlate wing() {
    return CurvedPlate({.origin = {100, 22, -62},
                        .along = {0.45, -0.88, 0.15},
                        .across = {0.34, 0.13, 0.93},
                        .bend = {-2.7, 0.00235, -0.0018, -0.0008},
                        .outline = rounded({{81, 5},
                                            {70, -20},
                                            {50, -44},
                                            {28, -74},
                                            {-2, -78},
                                            {-32, -66},
                                            {-48, -40},
                                            {-60, -27},
                                            {-86, -30},
                                            {-97, -4},
                                            {-80, 34},
                                            {-34, 60},
                                            {18, 68},
                                            {62, 48}}),
                        .thicknessMm = 8,
                        .rimMm = 7});
}

double hipBone(glm::dvec3 m) {
    static const CurvedPlate kWing = wing();
    double bone = kWing.distance(m);
    if (m.z < -60) {
        const double cup = glm::length(m - kHip) - kSocketMm - 8;
        const double front = smoothMin(coneDistance(m, {74, -22, -130}, 12, {42, -50, -136}, 8.5),
                                       coneDistance(m, {42, -50, -136}, 8.5, {11, -61, -147}, 11), 6);
        const double below = smoothMin(coneDistance(m, {9, -58, -158}, 9, {34, -22, -188}, 6.5),
                                       coneDistance(m, {34, -22, -188}, 6.5, {56, 22, -198}, 12), 5);
        const double seat = smoothMin(coneDistance(m, {80, 32, -148}, 15, {58, 34, -196}, 14),
                                      coneDistance(m, {72, 34, -150}, 7, {58, 56, -152}, 3.5), 6);
        const double pillar = coneDistance(m, {82, 30, -118}, 13, {66, 66, -98}, 7);
        bone = smoothMin(smoothMin(bone, cup, 10), smoothMin(seat, pillar, 8), 10);
        bone = smoothMin(bone, smoothMin(front, below, 6), 8);
    }
    // The socket opens to the side, forward and down.
    const double opening = glm::dot(m - kHip, glm::normalize(glm::dvec3(0.72, -0.36, -0.6))) - 4;
    const double socket = std::min(glm::length(m - kHip) - kSocketMm,
                                   std::max(-opening, glm::length(m - kHip) - kSocketMm - 14));
    return smoothMax(smoothMax(bone, -socket, 3), 2.4 - m.x, 2);
}

double sacrum(glm::dvec3 p) {
    const glm::dvec3 m = leftOf(p);
    const double middle = smoothMin(smoothMin(coneDistance(p, {0, 60, -70}, 20, {0, 84, -100}, 14),
                                              coneDistance(p, {0, 84, -100}, 14, {0, 95, -126}, 9), 8),
                                    coneDistance(p, {0, 95, -126}, 9, {0, 88, -152}, 4.5), 6);
    const double wings = smoothMin(coneDistance(m, {16, 60, -66}, 15, {42, 70, -73}, 13),
                                   coneDistance(m, {40, 78, -86}, 13, {14, 92, -118}, 8), 10);
    const double facets = coneDistance(m, {14, 83, -66}, 5, {14, 80, -45}, 4.5); // for the lowest vertebra
    const double crest = coneDistance(p, {0, 88, -72}, 5, {0, 106, -112}, 4);
    double bone = smoothMin(smoothMin(middle, wings, 8), smoothMin(crest, facets, 4), 8);
    for (int i = 0; i < 4; ++i) { // holes for the nerves
        const double x = 24 - 3.0 * i;
        const double y = 58 + 9.0 * i;
        const double z = -76 - 13.0 * i;
        bone = smoothMax(bone, -coneDistance(m, {x, y - 14, z - 4}, 4.5, {x - 1, y + 46, z + 4}, 3), 3);
    }
    const double canal = coneDistance(p, {0, 70, -48}, 8, {0, 94, -104}, 4);
    const double disc = p.z + 56 + spineTilt(-60) * (p.y - spineDepth(-60)); // flat on top
    return smoothMax(smoothMax(bone, -canal, 3), p.y < 78 ? disc : disc - 3 * (p.y - 78), 3);
}

} // namespace

double spineDepth(double z) { return 36 + (z > 25 ? 0.0009 : 0.0017) * (z - 25) * (z - 25); }

SpineDistances spine(glm::dvec3 p) {
    constexpr double kLowest = -53; // the disc above the sacrum
    constexpr double kLumbarMm = 36;
    constexpr double kThoracicMm = 31;
    constexpr double kFirstLumbar = kLowest + 5 * kLumbarMm;
    const double depth = p.y - spineDepth(p.z);
    if (std::abs(p.x) > 60 || depth < -50 || depth > 90) {
        return {kFar, kFar, kFar};
    }
    // Along the curve, whose discs are at right angles to it.
    const double height = p.z + glm::clamp(depth, -30.0, 40.0) * spineTilt(p.z);
    const bool isLumbar = height < kFirstLumbar;
    const double pitch = isLumbar ? kLumbarMm : kThoracicMm;
    const double along = (height - (isLumbar ? kLowest : kFirstLumbar)) / pitch;
    const double h = (along - std::floor(along) - 0.5) * pitch; // above the middle of its vertebra
    const double lumbar = glm::smoothstep(kFirstLumbar + 60, kFirstLumbar - 30, height);
    const glm::dvec2 radii = glm::mix(glm::dvec2(18, 15.5), glm::dvec2(25, 18), lumbar);
    const double half = 0.5 * pitch - glm::mix(2.6, 3.9, lumbar);
    const double waist = 3.2 * std::max(1 - h * h / (half * half), 0.0);
    const double column = ellipseDistance({p.x, depth}, radii);
    const double ends = kLowest - 1 - height;
    SpineDistances spine;
    spine.disc = std::max(column + 1, kLowest - 6 - height);
    spine.canal = ellipseDistance({p.x, depth - 25}, {10.5, 8.5});
    const double body = smoothMax(column + waist, std::abs(h) - half, 3);
    const double arch = vertebralArch({p.x, depth, h}, lumbar);
    spine.bone = std::max(smoothMax(smoothMin(body, arch, 3), -spine.canal, 2), ends);
    return spine;
}

double pelvis(glm::dvec3 p) {
    if (p.z > 15 || std::abs(p.x) > 165) {
        return kFar;
    }
    const double middle = p.z < -40 && std::abs(p.x) < 75 && p.y > 20 ? sacrum(p) : kFar;
    const glm::dvec3 m = leftOf(p);
    // The joint with the sacrum, whose wings press against the hip bones.
    return std::min(middle, smoothMax(hipBone(m), 4 - middle, 4));
}

double femora(glm::dvec3 p) {
    const glm::dvec3 m = leftOf(p);
    if (p.z > -95 || m.x < 40) {
        return kFar;
    }
    const double head = glm::length(m - kHip) - kHeadMm;
    const double neck = coneDistance(m, kHip, 13, {120, 13, -166}, 15);
    const double trochanter = smoothMin(ellipsoidDistance(m - glm::dvec3(130, 20, -152), {12, 16, 18}),
                                        coneDistance(m, {112, 20, -182}, 9, {103, 24, -194}, 7), 4);
    const double shaft = coneDistance(m, {120, 13, -172}, 17, {110, 4, -250}, 13.5);
    return smoothMin(smoothMin(head, neck, 3), smoothMin(trochanter, shaft, 10), 8);
}

} // namespace vs::phantom
