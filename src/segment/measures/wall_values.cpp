// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/wall_values.h"

#include "base/parallel.h"
#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSamples = 3; // of each ray, outside

// The values that are seen from one station.
struct Seen {
    std::vector<double> inside;
    std::array<std::vector<double>, kRays> outside;
};

void addValue(std::vector<double>& to, double value) {
    if (std::isfinite(value)) {
        to.push_back(value);
    }
}

// Values from a little outside the wall on. They end before another part of the vessel, which blurs what lies
// before it.
std::vector<double> valuesOutside(const ScanValues& values, const Lumen& lumen, const Station& station,
                                  std::size_t ray, double radiusMm) {
    const glm::dvec3 direction = rayOf(station, ray);
    const double apart = lumen.apartMm(direction);
    // Voxels whose centres lie half a voxel from the wall have values of both sides, values between voxels
    // those of voxels half as far again, and blur reaches a step further.
    const double first = 0.9 * apart + lumen.stepMm;
    std::vector<double> found;
    for (int i = 0; i < int(kSamples); ++i) {
        const double radius = radiusMm + first + 0.4 * apart * i;
        if (lumen.contains(station.place + radius * direction) ||
            lumen.contains(station.place + (radius + apart) * direction)) {
            break;
        }
        addValue(found, values.between(station.place + radius * direction));
    }
    return found;
}

Seen seenFrom(const ScanValues& values, const Lumen& lumen, const Station& station, const Outline& outline) {
    Seen seen;
    addValue(seen.inside, values.between(station.place));
    for (std::size_t ray = 0; ray < kRays; ++ray) {
        const double radius = outline.radiiMm[ray];
        if (ray % 4 == 0) {
            for (const double part : {0.2, 0.4}) {
                addValue(seen.inside, values.between(station.place + part * radius * rayOf(station, ray)));
            }
        }
        if (!outline.isOpen[ray]) {
            seen.outside[ray] = valuesOutside(values, lumen, station, ray, radius);
        }
    }
    return seen;
}

// How far values lie from their median, as the standard deviation of a Gaussian.
double spreadAround(std::vector<double> values, double middle) {
    for (double& value : values) {
        value = std::abs(value - middle);
    }
    return 1.48 * median(values);
}

void append(std::vector<double>& to, const std::vector<double>& values) {
    to.insert(to.end(), values.begin(), values.end());
}

// The stations within some length of one.
std::pair<std::size_t, std::size_t> stationsAround(const Curve& curve, std::size_t station, double mm) {
    std::size_t first = station;
    std::size_t last = station;
    while (first > 0 && curve[station].alongMm - curve[first - 1].alongMm <= mm) {
        --first;
    }
    while (last + 1 < curve.size() && curve[last + 1].alongMm - curve[station].alongMm <= mm) {
        ++last;
    }
    return {first, last + 1};
}

Plateaus plateausAt(const std::vector<Seen>& seen, const Lumen& lumen, const Curve& curve,
                    std::size_t station, double radiusMm) {
    // Values change slowly along the inside; what lies beside a vessel is soon another thing.
    const double step = std::max(lumen.stepMm, lumen.apartMm(curve[station].tangent));
    std::vector<double> inside;
    const auto [first, end] = stationsAround(curve, station, std::max(3 * step, 1.5 * radiusMm));
    for (std::size_t i = first; i < end; ++i) {
        append(inside, seen[i].inside);
    }
    Plateaus plateaus{median(inside), 0, {}};
    const double noiseInside = spreadAround(inside, plateaus.inside);
    plateaus.noise = 1.5 * noiseInside; // values between voxels have less of it, in the mean
    const auto [firstBeside, endBeside] = stationsAround(curve, station, 3 * step);
    for (std::size_t ray = 0; ray < kRays; ++ray) {
        std::vector<double> outside;
        std::size_t own = 0;
        for (std::size_t i = firstBeside; i < endBeside; ++i) {
            own += seen[i].outside[ray].size();
            for (const std::size_t turn :
                 {kRays - 2, kRays - 1, std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
                append(outside, seen[i].outside[(ray + turn) % kRays]);
            }
        }
        const double middle = median(outside);
        const double noise = std::max(noiseInside, spreadAround(outside, middle));
        // Beside another part of the vessel some stations see nothing outside, and others what lies between.
        const bool isClear = 4 * own >= 3 * kSamples * (endBeside - firstBeside) &&
                             std::abs(plateaus.inside - middle) > 3 * noise;
        plateaus.outside[ray] = isClear ? middle : kNoValue;
    }
    return plateaus;
}

} // namespace

double ScanValues::at(glm::ivec3 voxel) const {
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(voxel, lumen_.gridDims))) {
        return kNoValue;
    }
    const double value = volume_.at(voxel);
    return std::isfinite(value) ? value : kNoValue;
}

double ScanValues::between(const glm::dvec3& place) const {
    const glm::dvec3 voxel(lumen_.voxelFromWorld * glm::dvec4(place, 1));
    const glm::ivec3 first(glm::floor(voxel));
    const glm::dvec3 part = voxel - glm::dvec3(first);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            weight *= step[axis] == 1 ? part[axis] : 1 - part[axis];
        }
        sum += weight * at(first + step);
    }
    return sum;
}

std::vector<Plateaus> plateausAlong(const ScanValues& values, const Lumen& lumen, const Curve& curve,
                                    const std::vector<Outline>& outlines) {
    std::vector<Seen> seen(curve.size());
    inParallel(int(curve.size()), [&](int i) {
        const auto at = std::size_t(i);
        seen[at] = seenFrom(values, lumen, curve[at], outlines[at]);
    });
    std::vector<Plateaus> plateaus(curve.size());
    inParallel(int(curve.size()), [&](int i) {
        const auto at = std::size_t(i);
        plateaus[at] = plateausAt(seen, lumen, curve, at, outlines[at].typicalMm);
    });
    return plateaus;
}

} // namespace vs::segment
