// SPDX-License-Identifier: Apache-2.0
#include "phantom/branching.h"

#include "phantom/noise.h"

#include <cmath>
#include <numbers>

namespace vs::phantom {

namespace {

constexpr double kStepMm = 1.5;
constexpr double kLeastRadiusMm = 0.6;
constexpr double kTaper = 0.92; // of a branch's radius from its beginning to its end

glm::dvec3 normalAt(const Distance& surface, glm::dvec3 p) {
    constexpr double kAside = 1;
    const double here = surface(p);
    const auto along = [&](glm::dvec3 step) { return surface(p + step) - here; };
    const glm::dvec3 slope(along({kAside, 0, 0}), along({0, kAside, 0}), along({0, 0, kAside}));
    return slope / std::max(glm::length(slope), 1e-6);
}

// Numbers from 0 to 1 that follow from a seed.
class Choices {
public:
    explicit Choices(std::uint64_t seed) : state_(randomBits(seed)) {}
    double between(double least, double most) {
        state_ = randomBits(state_);
        return glm::mix(least, most, double(state_ >> 11) / double(1ULL << 53));
    }
    [[nodiscard]] std::uint64_t seed() const { return state_; }

private:
    std::uint64_t state_;
};

// `direction` turned about `axis`.
glm::dvec3 turned(glm::dvec3 direction, glm::dvec3 axis, double radians) {
    return std::cos(radians) * direction + std::sin(radians) * glm::cross(axis, direction) +
           (1 - std::cos(radians)) * glm::dot(axis, direction) * axis;
}

} // namespace

void growBranches(TubeSet& tubes, const Distance& surface, const Sprout& sprout) {
    Choices choices(sprout.seed);
    const double phase = choices.between(0, 2 * std::numbers::pi);
    const double pace = choices.between(0.22, 0.4); // of the meanders, radians a mm
    std::vector<TubePoint> places{sprout.from};
    glm::dvec3 direction = glm::normalize(sprout.direction);
    const int steps = std::max(2, int(std::lround(sprout.lengthMm / kStepMm)));
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec3 p = places.back().place;
        const glm::dvec3 normal = normalAt(surface, p);
        const double pull = std::clamp(-0.15 * surface(p), -0.7, 0.7); // towards the surface
        const glm::dvec3 tangent = direction - glm::dot(direction, normal) * normal;
        const glm::dvec3 towards = glm::normalize(tangent + 1e-6) + pull * normal;
        direction = glm::normalize(glm::mix(direction, glm::normalize(towards), 0.5));
        direction = turned(direction, normal, 0.17 * std::sin(phase + pace * kStepMm * i));
        const double taper = glm::mix(1.0, kTaper, double(i) / steps);
        places.push_back({p + kStepMm * direction, std::max(sprout.from.radius * taper, kLeastRadiusMm)});
    }
    tubes.add(places);
    const double radius = places.back().radius;
    if (sprout.divisions == 0 || radius <= kLeastRadiusMm) {
        return;
    }
    const glm::dvec3 normal = normalAt(surface, places.back().place);
    const double side = choices.between(0, 1) < 0.5 ? -1 : 1;
    const auto divide = [&](double radians, double thinner, double lengthMm) {
        choices.between(0, 1);
        growBranches(tubes, surface,
                     {{places.back().place, std::max(thinner * radius, kLeastRadiusMm)},
                      turned(direction, normal, radians),
                      lengthMm,
                      sprout.divisions - 1,
                      choices.seed()});
    };
    divide(side * choices.between(0.25, 0.5), 0.9, sprout.lengthMm * choices.between(0.75, 1.05));
    divide(-side * choices.between(0.5, 0.9), 0.78, sprout.lengthMm * choices.between(0.6, 0.95));
}

} // namespace vs::phantom
