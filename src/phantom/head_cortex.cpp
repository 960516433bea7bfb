// SPDX-License-Identifier: Apache-2.0
#include "phantom/head_cortex.h"

#include "phantom/solid_distances.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vs::phantom {

namespace {

constexpr double kTau = 2 * std::numbers::pi;
constexpr double kFluidMm = 2.6; // between brain and skull
constexpr double kRibbonMm = 2.9;

// A sum of plane waves of one wavelength in directions spread over the sphere: a smooth random field whose
// zero set meanders at about half that wavelength.
template <int N>
class WaveField {
public:
    struct Sample {
        double value = 0;
        glm::dvec3 gradient{0};
    };

    WaveField(double wavelengthMm, double seed) {
        for (int i = 0; i < N; ++i) {
            const double z = 1 - (2 * i + 1.0) / (2 * N); // a half sphere: opposite waves are the same wave
            const double angle = kTau * (0.6180339887498949 * i + seed);
            const double r = std::sqrt(1 - z * z);
            waves_[std::size_t(i)] = kTau / wavelengthMm * glm::dvec3(r * cos(angle), r * sin(angle), z);
            phases_[std::size_t(i)] = kTau * (0.7548776662466927 * i * i + 0.37 * i + seed);
        }
    }
    [[nodiscard]] Sample at(glm::dvec3 p) const {
        Sample sample;
        for (std::size_t i = 0; i < N; ++i) {
            const double phase = glm::dot(waves_[i], p) + phases_[i];
            sample.value += std::cos(phase);
            sample.gradient -= std::sin(phase) * waves_[i];
        }
        return sample;
    }

private:
    std::array<glm::dvec3, N> waves_;
    std::array<double, N> phases_;
};

// Distance from the zero set of a field, to first order; flat places count as a little sloped, or the
// saddles between two lines would open into pits.
double zeroDistance(double value, double slope, double leastSlope) {
    return std::abs(value) / std::hypot(slope, leastSlope);
}

// A cleft along a sheet: `across` is the distance from it, `below` how far above its bottom a place is.
double cleft(double across, double above, double halfWidth) {
    return (above > 0 ? across : std::hypot(across, above)) - halfWidth;
}

// Where the nearest place on a surface is, and the surface's normal there.
struct Foot {
    glm::dvec3 place{0};
    glm::dvec3 normal{0};
};

// Clefts along the zero set that a field has on a surface, carried inwards along the normals.
template <int N>
double sulci(const WaveField<N>& field, const Foot& foot, glm::dvec3 warp, double above, double halfWidth) {
    const auto sample = field.at(foot.place + warp);
    const double across = glm::length(sample.gradient - glm::dot(sample.gradient, foot.normal) * foot.normal);
    return cleft(zeroDistance(sample.value, across, 0.15), above, halfWidth);
}

glm::dvec2 sagittal(glm::dvec3 p) { return {p.y, p.z}; }

// The oval in the middle plane whose rim the corpus callosum follows; outside it the fissure parts the
// hemispheres.
double innerOval(glm::dvec3 p) { return ellipseDistance(sagittal(p) - glm::dvec2(6, -3), {42, 26}); }

double cerebrumHull(glm::dvec3 p, double room) {
    const glm::dvec3 mirrored(std::abs(p.x), p.y, p.z);
    const double upper = smoothMax(ellipsoidDistance(p - glm::dvec3(0, 4, 8), {66, 83, 59}), -25 - p.z, 8);
    const double temporal = ellipsoidDistance(mirrored - glm::dvec3(39, -3, -29), {23, 44, 21});
    const double hull = smoothMax(smoothMin(upper, temporal, 6), room + kFluidMm, 2);
    // What the tentorium covers belongs to the cerebellum.
    const double above = smoothMax(hull, 2.5 - cerebellumHull(p, room), 4);
    const double fissure = std::max(mirrored.x - 1.1, -innerOval(p));
    return smoothMax(above, -fissure, 4);
}

// The foot of a place near the cerebrum's hull, by the hull's slope.
Foot footOn(double hull, glm::dvec3 p, double room) {
    constexpr double kStep = 0.5;
    const auto along = [&](glm::dvec3 step) { return cerebrumHull(p + step, room) - hull; };
    const glm::dvec3 slope(along({kStep, 0, 0}), along({0, kStep, 0}), along({0, 0, kStep}));
    const glm::dvec3 normal = slope / std::max(glm::length(slope), 1e-6);
    return {p - hull * normal, normal};
}

// The cleft between the temporal lobe and what lies above it.
double sylvianFissure(glm::dvec3 p) {
    const double middle =
        -16 + 0.4 * (p.y + 36) + 2.5 * std::sin(0.16 * p.y + 0.06 * p.x) + 0.12 * std::abs(p.x);
    const double across = std::abs(p.z - middle) / 1.15;
    const double end = 6 * std::sin(0.1 * p.y);
    return smoothMax(across - 0.9, smoothMax(31 + end - std::abs(p.x), std::abs(p.y + 6) - 34, 6), 2);
}

} // namespace

FoldedSheet cerebrum(glm::dvec3 p, double room) {
    static const WaveField<14> large(26, 0.31);
    static const WaveField<9> small(14, 0.77);
    const double hull = cerebrumHull(p, room);
    constexpr double kDeepestMm = 27;
    if (hull > 4 || hull < -kDeepestMm) {
        return {hull, hull + kRibbonMm};
    }
    const Foot foot = footOn(hull, p, room);
    // No sulcus goes straight down.
    const glm::dvec3 warp = 2.2 * glm::sin(0.11 * glm::dvec3(p.y, p.z, p.x) + glm::dvec3(0, 1, 2));
    const double variation =
        std::sin(0.061 * p.x + 1) * std::sin(0.053 * p.y) + std::sin(0.07 * p.z + 0.04 * p.y);
    const double lips = std::exp(std::min(hull, 0.0) / 3); // sulci open towards the surface
    const double main = sulci(large, foot, warp, 15.5 + 3.5 * variation + hull, 0.5 + 0.8 * lips);
    const double minor = sulci(small, foot, -warp, 4.2 + 1.6 * variation + hull, 0.3 + 0.5 * lips);
    const double clefts = std::min({main, minor, sylvianFissure(p)});
    return {smoothMax(hull, -clefts, 2), std::max(hull, -clefts) + kRibbonMm};
}

double cerebellumHull(glm::dvec3 p, double room) {
    const glm::dvec3 mirrored(std::abs(p.x), p.y, p.z);
    const double lobes = ellipsoidDistance(mirrored - glm::dvec3(23, 50, -39), {29, 29, 23});
    const double vermis = ellipsoidDistance(p - glm::dvec3(0, 47, -37), {14, 25, 20});
    return smoothMax(smoothMin(lobes, vermis, 8), room + kFluidMm, 2);
}

FoldedSheet cerebellum(glm::dvec3 p, double room) {
    constexpr double kFoliaMm = 1.4; // thickness of the grey sheet
    const double hull = cerebellumHull(p, room);
    if (hull > 4) {
        return {hull, hull + kFoliaMm};
    }
    const glm::dvec2 fromVentricle = sagittal(p) - glm::dvec2(29, -38);
    const double radius = std::max(glm::length(fromVentricle), 4.0);
    constexpr double kSheets = 30; // to half a turn
    const double phase = kSheets * std::atan2(fromVentricle.y, fromVentricle.x) + 1.5 * std::sin(0.17 * p.x) +
                         0.8 * std::sin(0.3 * p.y);
    const double across = zeroDistance(std::sin(phase), kSheets / radius * std::cos(phase), 0.2);
    const double longer = 0.5 + 0.5 * std::sin(phase / 4.9); // every few folia a fissure goes deeper
    const double clefts = cleft(across, 5 + 7 * longer * longer + hull, 0.25 + 0.3 * longer);
    return {std::max(hull, -clefts), std::max(hull, -clefts) + kFoliaMm};
}

double corpusCallosum(glm::dvec3 p) {
    constexpr double kHalfThicknessMm = 3.3;
    const double band = std::abs(innerOval(p) + kHalfThicknessMm) - kHalfThicknessMm;
    // It spreads upwards into the white matter of both sides.
    const double spread = band - 0.02 * std::max(std::abs(p.x) - 6, 0.0) * std::abs(p.x);
    return smoothMax(smoothMax(spread, std::abs(p.x) - 17, 6), -6 - p.z, 4);
}

} // namespace vs::phantom
