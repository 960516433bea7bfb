// SPDX-License-Identifier: Apache-2.0
#include "phantom/skull_bones.h"

#include "phantom/curved_plate.h"
#include "phantom/skull_teeth.h"
#include "phantom/solid_distances.h"

#include <cmath>

namespace vs::phantom {

namespace {

constexpr double kFarFromBoneMm = 40; // a bound for what is not near

double noseCavity(glm::dvec3 p) {
    const double wide = ellipsoidDistance(p - glm::dvec3(0, -62, -55), {12.5, 36, 9});
    const double narrow = ellipsoidDistance(p - glm::dvec3(0, -64, -43), {7, 30, 16});
    return smoothMin(wide, narrow, 6);
}

// The rim in which teeth stand: so thick beside the arch, from `below` to `above`.
double alveolar(Jaw jaw, glm::dvec3 p, double below, double above) {
    const double beyond = std::max(below - p.z, p.z - above);
    if (beyond > 15) {
        return kFarFromBoneMm;
    }
    const ArchPlace place = besideArch(jaw, p);
    const double half = glm::mix(5.6, 7.6, glm::smoothstep(10.0, 45.0, place.alongMm));
    const double ripple = 0.5 * std::cos(0.8 * place.alongMm); // it follows the roots
    return smoothMax(place.distanceMm - half - 0.5 * ripple, beyond, 4);
}

double cheekBone(glm::dvec3 m) {
    const double body = smoothMin(coneDistance(m, {38, -70, -54}, 8, {49, -61, -48}, 6.5),
                                  coneDistance(m, {38, -68, -56}, 7, {30, -62, -68}, 7), 6);
    const double front = coneDistance(m, {50, -60, -47}, 5, {57, -38, -45}, 3.8);
    const double back = smoothMin(coneDistance(m, {57, -38, -45}, 3.8, {58.5, -18, -43}, 3.2),
                                  coneDistance(m, {58.5, -18, -43}, 3.2, {53, 4, -40}, 5), 4);
    return smoothMin(body, smoothMin(front, back, 4), 5);
}

// The rims of the orbits and the bridge of the nose.
double browAndRims(glm::dvec3 m) {
    const double brow = smoothMin(coneDistance(m, {6, -86, -15}, 6.5, {26, -84, -11}, 6),
                                  coneDistance(m, {26, -84, -11}, 6, {47, -68, -20}, 5), 6);
    const double side = smoothMin(coneDistance(m, {47, -68, -20}, 5, {49, -63, -36}, 4.4),
                                  coneDistance(m, {49, -63, -36}, 4.4, {46, -66, -48}, 5.5), 5);
    const double below = coneDistance(m, {44, -69, -51}, 5, {17, -80, -50}, 4.6);
    const double inner = smoothMin(coneDistance(m, {7, -85, -20}, 5, {12, -79, -38}, 3.8),
                                   coneDistance(m, {12, -79, -38}, 3.8, {17, -80, -54}, 5), 4);
    const double bridge = coneDistance(m, {1.5, -88, -22}, 4.5, {2.5, -96, -42}, 2.8);
    return smoothMin(smoothMin(brow, side, 5), smoothMin(below, smoothMin(inner, bridge, 5), 5), 5);
}

double upperJaw(glm::dvec3 p) {
    const glm::dvec3 m = mirrored(p);
    const double body = ellipsoidDistance(m - glm::dvec3(22, -58, -58), {22, 25, 17});
    const double rim = alveolar(Jaw::Upper, p, -77, -60);
    const double palate = smoothMax(std::abs(p.z + 64 + 0.004 * m.x * m.x) - 2.2,
                                    ellipseDistance({p.x, p.y + 48}, {31, 36}), 3);
    const double spike = coneDistance(p, {0, -82, -64}, 4, {0, -90, -63}, 1.6);
    const double wings = smoothMin(coneDistance(m, {14, -24, -52}, 4, {13, -26, -74}, 2.6),
                                   coneDistance(m, {14, -24, -52}, 4, {18, -17, -72}, 2.2), 3);
    return smoothMin(smoothMin(smoothMin(body, rim, 9), smoothMin(palate, spike, 3), 4), wings, 5);
}

CurvedPlate ramus() {
    return CurvedPlate({.origin = {45, -10, -80},
                        .along = {0.16, 1, 0},
                        .across = {0.06, 0, 1},
                        .bend = {0, 0.0015, 0, -0.001},
                        .outline = rounded({{13, 30},
                                            {6, 29},
                                            {2, 19},
                                            {-7, 18},
                                            {-14, 31},
                                            {-21, 27},
                                            {-20, -2},
                                            {-28, -20},
                                            {-30, -36},
                                            {-2, -34},
                                            {11, -26},
                                            {13, 0}}),
                        .thicknessMm = 7,
                        .rimMm = 1.5});
}

} // namespace

double orbits(glm::dvec3 p) {
    const glm::dvec3 m = mirrored(p);
    const double cone = coneDistance(m, {31, -78, -33}, 18.5, {13, -36, -31}, 4.5);
    const double boxy = ellipsoidDistance(m - glm::dvec3(31, -76, -33), {17.5, 26, 17});
    return smoothMin(cone, boxy, 4);
}

double airWays(glm::dvec3 p) {
    const glm::dvec3 m = mirrored(p);
    const double septum = 1.2 + 0.5 * std::sin(0.1 * p.y) - std::abs(p.x - 0.8 * std::sin(0.09 * p.z));
    const double shells = std::abs(std::sin(0.33 * p.z + 0.05 * m.x)) / 0.33 - 1.6;
    const double nose =
        smoothMax(smoothMax(noseCavity(p) + 1, septum, 1), 3.2 - std::max(shells, 7 - m.x), 1.5);
    const double throat = smoothMin(smoothMin(coneDistance(p, {0, -34, -54}, 7, {0, -15, -66}, 6.5),
                                              coneDistance(p, {0, -15, -66}, 6.5, {0, -12, -100}, 6), 5),
                                    coneDistance(p, {0, -12, -100}, 6, {0, -20, -160}, 8), 4);
    const double ear = coneDistance(m, {44, 8, -43}, 3, {90, 14, -37}, 4);
    return std::min({nose, throat, ear});
}

double sinuses(glm::dvec3 p) {
    const glm::dvec3 m = mirrored(p);
    const double brow = ellipsoidDistance(m - glm::dvec3(9, -84, -12), {6.5, 4, 6});
    const double sphenoid = ellipsoidDistance(m - glm::dvec3(7, -25, -36), {5.5, 9, 7});
    const double cheek = ellipsoidDistance(m - glm::dvec3(27, -56, -57), {9.5, 15, 8});
    const double walls = std::abs(std::sin(0.4 * p.y + 0.3 * p.z)) / 0.45 - 0.7; // of the ethmoid's cells
    const double cells = smoothMax(ellipsoidDistance(m - glm::dvec3(8, -58, -29), {5, 18, 8}), -walls, 1);
    return std::min({brow, sphenoid, cheek, cells});
}

double vault(glm::dvec3 p, const HeadShape& shape) {
    return shape.inner - 6.4 - 0.6 * std::sin(0.04 * p.y + 0.7);
}

double cranium(glm::dvec3 p, const HeadShape& shape) {
    const glm::dvec3 m = mirrored(p);
    double bone = vault(p, shape);
    if (p.y < 15 && p.z < 5 && p.z > -85) {
        const double face = smoothMin(smoothMin(upperJaw(p), cheekBone(m), 5), browAndRims(m), 5);
        const double core = smoothMin(ellipsoidDistance(p - glm::dvec3(0, -40, -36), {16, 36, 16}),
                                      coneDistance(m, {22, -38, -36}, 5, {40, -44, -28}, 3.5), 6);
        bone = smoothMin(bone, smoothMin(face, core, 5), 6);
        // Walls of the orbits are thin but closed, and so is the nose's.
        bone = smoothMin(bone, std::max(orbits(p) - 2.4, -66 - p.y), 2);
        bone = smoothMax(bone, -orbits(p), 2);
        bone = smoothMax(bone, -noseCavity(p), 2.5);
    }
    const double mastoid = coneDistance(m, {56, 26, -42}, 11, {51, 22, -66}, 6);
    const double styloid = coneDistance(m, {45, 12, -52}, 2.4, {40, 0, -80}, 1.3);
    const double condyle = coneDistance(m, {11, 14, -63}, 4, {15, 22, -62}, 4);
    bone = smoothMin(smoothMin(bone, mastoid, 8), std::min(styloid, condyle), 4);
    const double magnum = coneDistance(p, {0, 27, -30}, 15, {0, 29, -90}, 15);
    // The socket that the lower jaw turns in.
    const double joint = ellipsoidDistance(m - glm::dvec3(48, -2, -49), {11, 8, 7.5});
    return smoothMax(smoothMax(bone, -magnum, 3), -joint, 2);
}

double mandible(glm::dvec3 p) {
    static const CurvedPlate kRamus = ramus();
    const glm::dvec3 m = mirrored(p);
    if (p.z > -38 || p.y > 25) {
        return kFarFromBoneMm;
    }
    const double condyle = smoothMin(coneDistance(m, {44, -1, -50}, 4.2, {51, -3, -50}, 4.2),
                                     coneDistance(m, {47, -1, -51}, 4, {46.5, 2, -64}, 4), 4);
    const double border = std::min({coneDistance(m, {43, -10, -109}, 5, {38, -34, -111}, 6.5),
                                    coneDistance(m, {38, -34, -111}, 6.5, {27, -60, -114}, 7),
                                    coneDistance(m, {27, -60, -114}, 7, {12, -77, -115}, 7.5),
                                    coneDistance(m, {12, -77, -115}, 7.5, {0, -81, -115}, 8)});
    const double chin = smoothMin(ellipsoidDistance(p - glm::dvec3(0, -86, -117), {11, 6, 6}),
                                  ellipsoidDistance(m - glm::dvec3(12, -83, -119), {7, 5, 4}), 5);
    const double rim = alveolar(Jaw::Lower, p, -111, -98.6);
    const double line = coneDistance(m, {43, -24, -92}, 4.5, {33, -36, -103}, 5.5); // from ramus to teeth
    return smoothMin(smoothMin(smoothMin(kRamus.distance(m), condyle, 4), smoothMin(border, chin, 6), 8),
                     smoothMin(rim, line, 6), 8);
}

double neckVertebrae(glm::dvec3 p) {
    if (p.z > -50 || std::abs(p.x) > 42 || p.y < -10) {
        return kFarFromBoneMm;
    }
    const glm::dvec3 m = mirrored(p);
    // The atlas is a ring about the tooth of the axis.
    const double q = p.z + 73 - 0.12 * (p.y - 20);
    const double ring =
        smoothMax(std::abs(ellipseDistance({p.x, p.y - 22}, {19, 18})) - 3, std::abs(q) - 4.5, 3);
    const double masses = coneDistance(m, {18, 16, -70}, 6.5, {17, 18, -76}, 6.5);
    const double arms = coneDistance(m, {22, 17, -73}, 4.5, {36, 19, -74}, 3.4);
    double bone = smoothMin(smoothMin(ring, masses, 4), arms, 4);
    const double tooth = coneDistance(p, {0, 11.5, -67}, 4, {0, 13, -90}, 6);
    constexpr double kPitchMm = 17.5;
    constexpr double kTopZ = -83; // of the axis
    const double along = std::max((kTopZ - p.z + 0.1 * (p.y - 14)) / kPitchMm, 0.0);
    const double h = (std::floor(along) + 0.5 - along) * kPitchMm + (along > 0 ? 0.0 : p.z - kTopZ);
    const glm::dvec3 v(m.x, p.y - 14 - 0.004 * (p.z + 100) * (p.z + 100) * 0.1, h);
    const double body =
        smoothMax(ellipseDistance({v.x, v.y}, {11.5, 8.5}) + 1.2 - 0.012 * h * h, std::abs(h) - 6.9, 2);
    const double lateral = smoothMin(coneDistance(v, {18, 9, -8}, 4.6, {18, 7, 8}, 4.6),
                                     coneDistance(v, {10, 2, 0}, 4, {25, 1, -1}, 3.4), 4);
    const double lamina = coneDistance(v, {17, 11, 0}, 3.6, {1, 27, -3}, 3);
    const double spinous = coneDistance(v, {0.5, 27, -3}, 3.4, {3, 41, -7}, 2.6);
    bone = std::min(bone, smoothMin(smoothMin(body, lateral, 4), smoothMin(lamina, spinous, 4), 4));
    return smoothMin(bone, std::max(tooth, 3.5 - ring), 1);
}

} // namespace vs::phantom
