// SPDX-License-Identifier: Apache-2.0
#include "render/colours/segment_palette.h"

#include "base/check.h"
#include "render/colours/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace vs::render {

namespace {

// Without black; the one that stands out from ivory first.
constexpr std::array<glm::dvec3, 7> kFirst{{{0.855, 0.450, 0.221},
                                            {0.0, 0.447, 0.698},
                                            {0.0, 0.620, 0.451},
                                            {0.902, 0.624, 0.0},
                                            {0.800, 0.475, 0.655},
                                            {0.337, 0.706, 0.914},
                                            {0.941, 0.894, 0.259}}};
constexpr std::size_t kLabels = 255;
constexpr std::size_t kNeighbours = 12;  // labels before one that often lie beside it
constexpr double kNeighbourWeight = 0.4; // their distances count as so much shorter
// Of OKLab: neither as dark as the background, nor as pale as bone.
constexpr double kDarkest = 0.45;
constexpr double kLightest = 0.86;
constexpr double kPalest = 0.07;
constexpr int kSteps = 24; // of each channel, from which colours are chosen

glm::dvec3 labOf(glm::dvec3 display) { return oklabFromLinear(linearFromDisplay(display)); }

struct Choice {
    glm::dvec3 display;
    glm::dvec3 lab;
};

std::vector<Choice> choices() {
    std::vector<Choice> all;
    for (int n = 0; n < kSteps * kSteps * kSteps; ++n) {
        const glm::dvec3 display =
            glm::dvec3(n % kSteps, n / kSteps % kSteps, n / kSteps / kSteps) / double(kSteps - 1);
        const glm::dvec3 lab = labOf(display);
        if (lab.x >= kDarkest && lab.x <= kLightest && std::hypot(lab.y, lab.z) >= kPalest) {
            all.push_back({display, lab});
        }
    }
    return all;
}

// How far a choice is from the colours there are, the last of which count as nearer. `fromOthers` is its
// distance to the nearest of the others.
double distanceTo(const std::vector<glm::dvec3>& labs, glm::dvec3 lab, double fromOthers) {
    double least = fromOthers;
    for (std::size_t i = labs.size() - std::min(labs.size(), kNeighbours); i < labs.size(); ++i) {
        least = std::min(least, kNeighbourWeight * glm::distance(labs[i], lab));
    }
    return least;
}

std::vector<glm::dvec3> makePalette() {
    std::vector<glm::dvec3> colours(kFirst.begin(), kFirst.end());
    std::vector<glm::dvec3> labs;
    std::transform(colours.begin(), colours.end(), std::back_inserter(labs), labOf);
    const std::vector<Choice> all = choices();
    std::vector<double> fromOthers(all.size(), 1e30);
    while (colours.size() < kLabels) {
        std::size_t best = 0;
        double farthest = -1;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (labs.size() > kNeighbours) { // the one that is no neighbour any more
                const glm::dvec3 left = labs[labs.size() - kNeighbours - 1];
                fromOthers[i] = std::min(fromOthers[i], glm::distance(left, all[i].lab));
            }
            const double distance = distanceTo(labs, all[i].lab, fromOthers[i]);
            if (distance > farthest + 1e-9) { // the first of equals, on any machine
                farthest = distance;
                best = i;
            }
        }
        colours.push_back(all[best].display);
        labs.push_back(all[best].lab);
    }
    return colours;
}

} // namespace

glm::dvec3 segmentColour(int label) {
    VS_CHECK(label >= 1 && label <= int(kLabels));
    if (label <= int(kFirst.size())) {
        return kFirst[std::size_t(label - 1)];
    }
    static const std::vector<glm::dvec3> palette = makePalette();
    return palette[std::size_t(label - 1)];
}

} // namespace vs::render
