// SPDX-License-Identifier: Apache-2.0
#include "phantom/artery_tree.h"

#include "phantom/branching.h"
#include "phantom/head_cortex.h"
#include "phantom/head_shape.h"
#include "phantom/solid_distances.h"

#include <cmath>
#include <initializer_list>

namespace vs::phantom {

namespace {

constexpr double kReachMm = 4;
constexpr double kBlendMm = 1.5;

glm::dvec3 skullPlace(glm::dvec3 p) { return {p.x * (1 - 0.0012 * p.y), p.y, p.z}; }
double roomFor(glm::dvec3 p) { return skullInside(skullPlace(p)); }

// Signed distance to one hemisphere without its folds: arteries lie on its outside, its base, and its wall
// towards the other one.
double hemisphere(glm::dvec3 p) {
    const double outside = smoothMax(roomFor(p) + 4.5, 2.6 - std::abs(p.x), 10);
    const double base = glm::mix(-70.0, -14.0, glm::smoothstep(0.0, 22.0, p.y)); // what the tentorium bears
    return smoothMax(outside, 0.7 * (base - p.z), 8);
}

double cerebellumSurface(glm::dvec3 p) { return cerebellumHull(skullPlace(p), roomFor(p)) - 0.5; }

// Draws one side's arteries. Places are told for the left; each side bends them in its own way, but for what
// lies in the middle, where both meet.
class Side {
public:
    Side(TubeSet& tubes, double sign) : tubes_(tubes), sign_(sign) {}

    void drawAll() {
        drawCarotid();
        drawMiddleCerebral();
        drawAnteriorCerebral();
        drawPosteriorCerebral();
        drawCerebellar();
    }

private:
    using Course = std::initializer_list<TubePoint>;

    [[nodiscard]] glm::dvec3 bent(glm::dvec3 p) const {
        const glm::dvec3 shift = 1.3 * glm::sin(0.11 * glm::dvec3(p.y, p.z, p.x) + glm::dvec3(0.4, 1.9, 3.2) +
                                                (sign_ > 0 ? 0.0 : 2.3));
        const double aside = glm::smoothstep(3.0, 12.0, p.x);
        const double falx = (1 - aside) * 0.9 * std::sin(0.13 * p.z + 0.08 * p.y); // it is not quite straight
        const glm::dvec3 moved = p + (p.x > 0 ? std::max(aside, 0.5) : 0.0) * shift;
        return {sign_ * (aside * moved.x + (1 - aside) * p.x) + falx, moved.y, moved.z};
    }
    void draw(Course course) {
        std::vector<TubePoint> places;
        for (const TubePoint& point : course) {
            places.push_back({bent(point.place), point.radius});
        }
        tubes_.add(smoothTube(places));
    }
    // Draws an artery that comes to a surface and branches over it.
    void spread(Course course, const Distance& surface, double lengthMm, int divisions) {
        draw(course);
        const TubePoint& last = *(course.end() - 1);
        const glm::dvec3 before = bent((course.end() - 2)->place);
        const glm::dvec3 end = bent(last.place);
        growBranches(tubes_, surface, {{end, last.radius}, end - before, lengthMm, divisions, ++seed_});
    }
    void drawCarotid();
    void drawMiddleCerebral();
    void drawAnteriorCerebral();
    void drawPosteriorCerebral();
    void drawCerebellar();

    TubeSet& tubes_;
    double sign_;
    std::uint64_t seed_ = sign_ > 0 ? 100 : 200;
};

// Up through the skull's base, forward beside the sella, and back in the siphon.
void Side::drawCarotid() {
    draw({{{27, 1, -98}, 2.6},
          {{26, -2, -86}, 2.5},
          {{25.5, -1, -74}, 2.5},
          {{25, 0, -63}, 2.4},
          {{23, -3, -55}, 2.3},
          {{18, -9, -51}, 2.3},
          {{14, -14, -46}, 2.3},
          {{12.5, -18, -39}, 2.3},
          {{13, -24, -34}, 2.3},
          {{13.5, -32, -32}, 2.3},
          {{13, -37, -27}, 2.2},
          {{12, -33, -21.5}, 2.2},
          {{11.5, -26, -21}, 2.1},
          {{11.5, -20.5, -18.5}, 2},
          {{13, -17.5, -15}, 1.9}});
    draw({{{12, -33, -21.5}, 0.8},
          {{14, -41, -26}, 0.7},
          {{20, -52, -29}, 0.65},
          {{24, -63, -27}, 0.55}}); // eye
    draw(
        {{{11.5, -20.5, -18.5}, 0.8}, {{9.5, -12, -20}, 0.75}, {{9, -1, -19}, 0.8}}); // to the basilar's side
    spread({{{12.2, -19, -16.5}, 0.6}, {{14, -10, -18}, 0.6}, {{19, 2, -18}, 0.55}}, hemisphere, 12, 1);
}

// Along the insula in two trunks, and out over the lips of the lateral fissure.
void Side::drawMiddleCerebral() {
    draw({{{13, -17.5, -15}, 1.6},
          {{21, -18.5, -14.5}, 1.55},
          {{28, -17, -16.5}, 1.5},
          {{35, -14, -16}, 1.5}});
    draw({{{35, -14, -16}, 1.25},
          {{40, -17, -9}, 1.2},
          {{42, -12, -2}, 1.15},
          {{42, -2, 3}, 1.1},
          {{41, 10, 6}, 1},
          {{40, 20, 8}, 0.95}});
    draw({{{35, -14, -16}, 1.25},
          {{40, -10, -13}, 1.2},
          {{42, -2, -9}, 1.15},
          {{42, 9, -5}, 1.1},
          {{41, 20, 0}, 1},
          {{41, 29, 5}, 0.95}});
    spread({{{40, -17, -9}, 0.9}, {{46, -23, -9}, 0.9}, {{52, -31, -4}, 0.85}}, hemisphere, 14, 3);
    spread({{{42, -12, -2}, 0.9}, {{49, -14, -1}, 0.9}, {{57, -17, 5}, 0.85}}, hemisphere, 15, 3);
    spread({{{42, -2, 3}, 0.9}, {{50, -1, 3}, 0.9}, {{61, -1, 10}, 0.85}}, hemisphere, 16, 3);
    spread({{{40, 20, 8}, 0.9}, {{48, 21, 10}, 0.9}, {{59, 22, 19}, 0.85}}, hemisphere, 15, 3);
    spread({{{40, -10, -13}, 0.85}, {{47, -13, -15}, 0.85}, {{53, -18, -23}, 0.8}}, hemisphere, 12, 2);
    spread({{{42, -2, -9}, 0.9}, {{51, 0, -8}, 0.9}, {{61, 3, -15}, 0.85}}, hemisphere, 13, 3);
    spread({{{42, 9, -5}, 0.9}, {{52, 13, -4}, 0.9}, {{62, 20, -8}, 0.85}}, hemisphere, 14, 3);
    spread({{{41, 29, 5}, 0.9}, {{49, 33, 6}, 0.9}, {{58, 40, 9}, 0.85}}, hemisphere, 15, 3);
}

// Towards the middle, up before the corpus callosum and back over it.
void Side::drawAnteriorCerebral() {
    draw({{{13, -17.5, -15}, 1.25}, {{8, -21, -13.5}, 1.2}, {{3, -26, -13}, 1.2}});
    draw({{{3, -26, -13}, 1.15},
          {{2.4, -33, -9}, 1.15},
          {{2.2, -40, 2}, 1.1},
          {{2.2, -40, 12}, 1.1},
          {{2.2, -32, 21}, 1.05},
          {{2.2, -18, 27}, 1},
          {{2.2, 0, 29}, 0.95},
          {{2.2, 18, 27}, 0.85}});
    draw({{{2.2, -40, 12}, 0.95}, {{2.6, -41, 24}, 0.95}, {{2.6, -32, 34}, 0.9}, {{2.6, -14, 42}, 0.85}});
    spread({{{2.3, -36, -5}, 0.75}, {{3, -44, -6}, 0.75}, {{3.5, -52, -4}, 0.7}}, hemisphere, 13, 2);
    spread({{{2.2, -40, 4}, 0.8}, {{2.8, -47, 7}, 0.8}, {{2.8, -56, 14}, 0.75}}, hemisphere, 14, 2);
    spread({{{2.6, -41, 24}, 0.8}, {{2.6, -46, 32}, 0.8}, {{2.6, -48, 40}, 0.75}}, hemisphere, 13, 2);
    spread({{{2.6, -32, 34}, 0.8}, {{2.6, -29, 41}, 0.8}, {{2.6, -30, 49}, 0.75}}, hemisphere, 13, 2);
    spread({{{2.6, -14, 42}, 0.8}, {{2.6, -3, 46}, 0.8}, {{2.6, 6, 53}, 0.75}}, hemisphere, 14, 2);
    spread({{{2.2, 18, 27}, 0.85}, {{2.4, 30, 29}, 0.8}, {{2.6, 40, 36}, 0.75}}, hemisphere, 15, 3);
}

// From the basilar's tip around the midbrain, over the tentorium, to the back.
void Side::drawPosteriorCerebral() {
    draw({{{0, -1, -20}, 1.3},
          {{4, -2, -19}, 1.25},
          {{9, -1, -19}, 1.25},
          {{15, 5, -19}, 1.2},
          {{18.5, 15, -17.5}, 1.15},
          {{18, 25, -14}, 1.1},
          {{15, 35, -9}, 1.05},
          {{12, 45, -5}, 1}});
    spread({{{12, 45, -5}, 0.85}, {{9, 56, -1}, 0.85}, {{6, 66, 1}, 0.8}}, hemisphere, 14, 2);
    spread({{{12, 45, -5}, 0.85}, {{9, 52, 4}, 0.85}, {{5, 60, 13}, 0.8}}, hemisphere, 14, 3);
    spread({{{18, 25, -14}, 0.8}, {{25, 31, -13}, 0.8}, {{33, 37, -13}, 0.75}}, hemisphere, 14, 2);
    spread({{{17.5, 11, -18.5}, 0.75}, {{24, 10, -22}, 0.75}, {{31, 10, -28}, 0.7}}, hemisphere, 13, 2);
}

// The vertebral artery around the atlas, and what supplies the cerebellum.
void Side::drawCerebellar() {
    draw({{{17, 11, -98}, 1.6},
          {{17, 13, -87}, 1.6},
          {{20, 19, -78}, 1.6},
          {{20.5, 27, -73}, 1.6},
          {{15, 31, -68.5}, 1.55},
          {{8.5, 26, -63}, 1.5},
          {{4, 19, -58}, 1.5},
          {{0, 12.5, -53.5}, 1.5}});
    spread({{{0.5, -3, -23.5}, 0.8}, {{8, 1, -24}, 0.8}, {{16, 11, -23}, 0.8}, {{19, 24, -20}, 0.75}},
           cerebellumSurface, 14, 2);
    spread({{{0, 3, -43}, 0.7}, {{8, 5, -43}, 0.7}, {{17, 9, -42}, 0.65}, {{26, 17, -44}, 0.6}},
           cerebellumSurface, 13, 1);
    spread({{{8.5, 26, -63}, 0.75}, {{11, 31, -59}, 0.75}, {{10, 40, -60}, 0.7}, {{16, 50, -63}, 0.65}},
           cerebellumSurface, 13, 1);
}

} // namespace

TubeSet arteryTree() {
    TubeSet tubes(kReachMm, kBlendMm);
    Side(tubes, 1).drawAll();
    Side(tubes, -1).drawAll();
    const auto draw = [&](std::initializer_list<TubePoint> course) {
        tubes.add(smoothTube(std::span(course.begin(), course.size())));
    };
    draw({{{0, 12.5, -53.5}, 1.75},
          {{0.6, 6, -46}, 1.7},
          {{-0.8, 0.5, -38}, 1.7},
          {{-0.5, -3.5, -31}, 1.6},
          {{0.4, -3.5, -25}, 1.6},
          {{0, -1, -20}, 1.6}});
    draw({{{3, -26, -13}, 0.9}, {{0, -26.8, -13}, 0.85}, {{-3, -26, -13}, 0.9}});
    tubes.add(std::vector<TubePoint>{
        {{-35, -14, -16}, 1.5}, {{-37.5, -17.5, -18.5}, 1.9}, {{-39.5, -20.5, -20.5}, 3.3}});
    tubes.finish();
    return tubes;
}

TubeSet veinTree() {
    TubeSet tubes(kReachMm, kBlendMm);
    const auto draw = [&](std::initializer_list<TubePoint> course) {
        tubes.add(smoothTube(std::span(course.begin(), course.size())));
    };
    draw({{{-25.5, -1, -77}, 1.5},
          {{-29, -6, -82}, 1.5},
          {{-32, -12, -80}, 1.5},
          {{-32, -17, -72}, 1.5},
          {{-35, -22, -68}, 1.5},
          {{-37, -27, -75}, 1.5},
          {{-40, -34, -80}, 1.5},
          {{-43, -42, -76}, 1.6}});
    draw({{{-46, -42, -62}, 1.8},
          {{-57, -33, -46}, 1.6},
          {{-65, -27, -26}, 1.4},
          {{-68, -24, 0}, 1.3},
          {{-65, -36, 15}, 1.1}});
    tubes.finish();
    return tubes;
}

} // namespace vs::phantom
