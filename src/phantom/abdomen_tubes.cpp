// SPDX-License-Identifier: Apache-2.0
#include "phantom/abdomen_tubes.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace vs::phantom {

namespace {

using Course = std::vector<TubePoint>;

const Course kAorta{{{11, 34, 245}, 12.5}, {{10, 27, 190}, 12}, {{9, 16, 140}, 11.5}, {{8, 6, 95}, 11},
                    {{8, 1, 60}, 10.5},    {{7, 1, 30}, 10},    {{5, 4, 8}, 10}};
const Course kLeftIliac{{{5, 4, 8}, 8},         {{16, 5, -8}, 6.8},   {{28, 9, -28}, 6.5},
                        {{44, 15, -54}, 6.3},   {{56, 4, -78}, 5.6},  {{62, -21, -102}, 5.4},
                        {{74, -38, -124}, 5.3}, {{84, -47, -150}, 5}, {{88, -44, -185}, 4.8},
                        {{86, -36, -245}, 4.6}};
const Course kRightIliac{{{5, 4, 8}, 8},          {{-7, 6, -7}, 6.8},    {{-22, 11, -28}, 6.5},
                         {{-40, 18, -52}, 6.3},   {{-55, 6, -77}, 5.6},  {{-61, -22, -102}, 5.4},
                         {{-71, -46, -124}, 5.3}, {{-83, -54, -150}, 5}, {{-87, -48, -185}, 4.8},
                         {{-85, -36, -245}, 4.6}};

// Rings of zigzags from `fromMm` to `toMm` along a tube, `beside` its surface.
void addRings(TubeSet& wires, const Course& tube, double fromMm, double toMm, int points) {
    constexpr double kRingMm = 13;
    constexpr double kGapMm = 1.5;
    constexpr double kWireMm = 1.1; // radius
    constexpr int kPieces = 3;      // of one zig, so that it follows the round
    const auto placeAt = [&](double alongMm, double angle) {
        double start = 0;
        for (std::size_t i = 0; i + 1 < tube.size(); ++i) {
            const glm::dvec3 axis = tube[i + 1].place - tube[i].place;
            const double length = glm::length(axis);
            if (alongMm < start + length || i + 2 == tube.size()) {
                const double t = (alongMm - start) / length;
                const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0)));
                const glm::dvec3 front = glm::cross(side, axis / length);
                const double radius = glm::mix(tube[i].radius, tube[i + 1].radius, t) + 0.2;
                return tube[i].place + t * axis + radius * (std::cos(angle) * side + std::sin(angle) * front);
            }
            start += length;
        }
        return tube.back().place;
    };
    double turn = 0; // every ring is turned a little
    for (double begin = fromMm; begin + kRingMm <= toMm; begin += kRingMm + kGapMm, turn += 0.5) {
        std::vector<TubePoint> ring;
        for (int i = 0; i <= 2 * points * kPieces; ++i) {
            const double zig = double(i) / kPieces;
            const double up = std::abs(zig - 2 * std::floor(0.5 * zig + 0.5)); // 0 to 1 and back
            const double angle = (zig + turn) * std::numbers::pi / points;
            ring.push_back({placeAt(begin + kRingMm * up, angle), kWireMm});
        }
        wires.add(ring);
    }
}

// One rib and the same one on the other side: from its vertebra around the trunk, falling forward.
struct Rib {
    double vertebraZ;
    double depth;    // y of its head
    double sideZ;    // where it crosses the side
    double endAngle; // how far around it goes: 0 at the back, pi in front
    double endZ;
};

void addRib(TubeSet& ribs, const Rib& rib, double side) {
    std::vector<TubePoint> through;
    const auto add = [&](glm::dvec3 p) { through.push_back({{side * p.x, p.y, p.z}, 3.7}); };
    add({21, rib.depth + 6, rib.vertebraZ});
    add({35, rib.depth + 32, rib.vertebraZ - 2});
    const double bias = side > 0 ? 0.0 : 1.5; // no two sides are quite alike
    for (double angle = 0.55; angle < rib.endAngle + 0.01; angle += (rib.endAngle - 0.55) / 6) {
        const double share = (angle - 0.2) / (std::numbers::pi / 2 - 0.2); // 1 at the side
        const double after =
            std::max(angle - std::numbers::pi / 2, 0.0) / std::max(rib.endAngle - std::numbers::pi / 2, 0.01);
        const double z = share < 1 ? glm::mix(rib.vertebraZ - 4, rib.sideZ, share * (0.6 + 0.4 * share))
                                   : glm::mix(rib.sideZ, rib.endZ, after);
        add({151 * std::sin(angle), 93 * std::cos(angle), z + bias});
    }
    const auto middle = smoothTube(through);
    // Ribs are higher than thick.
    for (const double up : {-3.2, 3.2}) {
        std::vector<TubePoint> edge = middle;
        for (TubePoint& point : edge) {
            point.place.z += up;
        }
        ribs.add(edge);
    }
}

} // namespace

TubeSet abdominalArteries() {
    TubeSet arteries(20, 3);
    const auto draw = [&](const Course& course) { arteries.add(smoothTube(course)); };
    draw(kAorta);
    draw(kLeftIliac);
    draw(kRightIliac);
    draw({{{14, 8, 98}, 3.6}, {{28, 12, 99}, 3.2}, {{42, 30, 97}, 3}, {{56, 46, 96}, 2.4}}); // renal ones
    draw({{{2, 7, 94}, 3.6}, {{-12, 6, 92}, 3.2}, {{-30, 20, 87}, 3}, {{-54, 46, 82}, 2.4}});
    draw({{{9, 6, 112}, 3.4},
          {{8, -14, 100}, 3.2},
          {{6, -22, 70}, 2.8},
          {{0, -26, 30}, 2.2},
          {{-8, -28, 0}, 1.6}}); // to the gut
    draw({{{44, 15, -54}, 4},
          {{50, 34, -78}, 3.8},
          {{52, 50, -102}, 3},
          {{48, 56, -126}, 2.2}}); // into the pelvis
    draw({{{-40, 18, -52}, 4}, {{-47, 36, -76}, 3.8}, {{-51, 50, -101}, 3}, {{-47, 56, -124}, 2.2}});
    arteries.finish();
    return arteries;
}

TubeSet stentWires() {
    TubeSet wires(4, 0.1);
    const auto aorta = smoothTube(kAorta);
    double length = 0;
    for (std::size_t i = 0; i + 1 < aorta.size(); ++i) {
        length += glm::length(aorta[i + 1].place - aorta[i].place);
    }
    addRings(wires, aorta, length - 92, length, 6);
    addRings(wires, smoothTube(kLeftIliac), 4, 64, 4);
    addRings(wires, smoothTube(kRightIliac), 6, 66, 4);
    wires.finish();
    return wires;
}

TubeSet lowerRibs() {
    TubeSet ribs(6, 3);
    for (const double side : {1.0, -1.0}) {
        addRib(ribs, {316, 92, 214, 2.55, 190}, side);
        addRib(ribs, {287, 88, 187, 2.45, 158}, side);
        addRib(ribs, {258, 82, 160, 2.3, 128}, side);
        addRib(ribs, {226, 72, 132, 2.1, 100}, side);
        addRib(ribs, {195, 62, 112, 1.65, 108}, side);
        addRib(ribs, {164, 53, 92, 1.1, 92}, side);
    }
    ribs.finish();
    return ribs;
}

TubeSet colonCourse() {
    TubeSet colon(30, 1);
    colon.add(smoothTube(
        Course{{{-75, -48, -76}, 20},  {{-80, -45, -62}, 25}, {{-88, -40, -30}, 26}, {{-102, -30, 10}, 26},
               {{-108, -20, 48}, 25},  {{-105, -20, 76}, 24}, {{-90, -36, 92}, 23},  {{-62, -50, 74}, 23},
               {{-22, -58, 50}, 23},   {{22, -58, 46}, 22},   {{60, -50, 70}, 22},   {{90, -34, 102}, 22},
               {{108, -10, 124}, 21},  {{116, 8, 104}, 20},   {{112, 12, 60}, 19.5}, {{101, 4, 10}, 19},
               {{92, -14, -34}, 18.5}, {{76, -38, -64}, 18},  {{48, -52, -80}, 18},  {{8, -54, -64}, 18.5},
               {{-24, -36, -70}, 19},  {{-30, -2, -92}, 19},  {{-10, 32, -106}, 20}, {{0, 52, -127}, 22},
               {{1, 54, -156}, 21},    {{0, 48, -182}, 13}}));
    colon.finish();
    return colon;
}

} // namespace vs::phantom
