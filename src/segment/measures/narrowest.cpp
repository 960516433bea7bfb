// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/narrowest.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

constexpr double kSideDiameters = 10; // how much of the vessel on either side tells what is healthy

// What a side says: its healthy diameter and where that is.
struct Healthy {
    double alongMm = 0;
    double diameterMm = 0;
};

// The points of a row from `begin` to before `end`.
Healthy healthyOf(const Vessel& vessel, std::size_t begin, std::size_t end) {
    std::vector<double> diameters;
    for (std::size_t i = begin; i < end; ++i) {
        diameters.push_back(vessel.points[i].diameterMm);
    }
    const auto quarter = diameters.end() - 1 - std::ptrdiff_t((diameters.size() - 1) / 4);
    std::nth_element(diameters.begin(), quarter, diameters.end());
    // The widest quarter lies where its points do, in the mean.
    Healthy healthy{0, *quarter};
    double count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        // Points as wide but for rounding lie all along an even vessel.
        if (vessel.points[i].diameterMm >= healthy.diameterMm * (1 - 1e-3)) {
            healthy.alongMm += vessel.points[i].alongMm;
            count += 1;
        }
    }
    healthy.alongMm /= count;
    return healthy;
}

// How many points of a vessel are as long as `mm`.
std::size_t pointsIn(const Vessel& vessel, double mm) {
    const double apart = vessel.lengthMm / double(vessel.points.size() - 1);
    return std::size_t(std::ceil(mm / apart));
}

double referenceAt(const Vessel& vessel, std::size_t index, std::size_t side) {
    const Healthy before = healthyOf(vessel, index - std::min(index, side), index);
    const Healthy after = healthyOf(vessel, index + 1, std::min(index + 1 + side, vessel.points.size()));
    const double part = (vessel.points[index].alongMm - before.alongMm) / (after.alongMm - before.alongMm);
    return glm::mix(before.diameterMm, after.diameterMm, part);
}

// The middle of the part around a place that is nearly as narrow: single values are known to a fraction of a
// voxel only, by which the narrowest of them can lie anywhere in a narrow stretch.
std::size_t middleOfNarrow(const Vessel& vessel, std::size_t index, double referenceMm) {
    const double narrow = vessel.points[index].diameterMm;
    const double limit = narrow + 0.2 * std::max(0.0, referenceMm - narrow);
    std::size_t first = index;
    std::size_t last = index;
    while (first > 0 && vessel.points[first - 1].diameterMm <= limit) {
        --first;
    }
    while (last + 1 < vessel.points.size() && vessel.points[last + 1].diameterMm <= limit) {
        ++last;
    }
    return (first + last) / 2;
}

} // namespace

std::optional<Narrowest> narrowestOf(const Vessel& vessel) {
    std::vector<double> diameters;
    for (const VesselPoint& point : vessel.points) {
        diameters.push_back(point.diameterMm);
    }
    const double typical = median(diameters);
    if (!(typical > 0) || vessel.lengthMm <= 2 * typical) {
        return {};
    }
    const std::size_t edge = pointsIn(vessel, typical);
    const std::size_t side = pointsIn(vessel, kSideDiameters * typical);
    std::optional<Narrowest> found;
    for (std::size_t i = edge; i + edge < vessel.points.size(); ++i) {
        const double reference = referenceAt(vessel, i, side);
        const double percent = 100 * (1 - diameters[i] / reference);
        if (!found || percent > found->stenosisPercent) {
            found = Narrowest{i, diameters[i], reference, percent};
        }
    }
    if (found) {
        found->index = middleOfNarrow(vessel, found->index, found->referenceDiameterMm);
        found->diameterMm = std::min(found->diameterMm, diameters[found->index]);
    }
    return found;
}

} // namespace vs::segment
