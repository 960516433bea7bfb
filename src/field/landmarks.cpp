// SPDX-License-Identifier: Apache-2.0
#include "field/landmarks.h"

#include "field/histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vs::field {

namespace {

constexpr double kHalfWidths = 4; // above air's peak, that its noise reaches
// Of the way from air to the object: so far at least, and where air was set to one value, which tells of no
// noise, so far.
constexpr double kWayFromNoise = 0.25;
constexpr double kWayFromOneValue = 0.5;
constexpr int kAirBins = 64; // from the darkest value to the object: finer, scaled values comb

// So many bins as one.
std::vector<double> joined(const std::vector<std::uint32_t>& counts, std::size_t bins) {
    std::vector<double> sums((counts.size() + bins - 1) / bins, 0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        sums[i / bins] += counts[i];
    }
    return sums;
}

} // namespace

Air findAir(const std::vector<std::uint32_t>& counts, const Range& range, double object) {
    const double binWidth = range.width() / double(counts.size());
    const double darkBins = (object - range.lo) / binWidth;
    const auto together = std::size_t(std::max(1.0, std::floor(darkBins / kAirBins)));
    const double width = binWidth * double(together);
    const std::vector<double> sums = joined(counts, together);
    const auto end = sums.begin() + std::ptrdiff_t(std::clamp(std::size_t((object - range.lo) / width),
                                                              std::size_t(1), sums.size()));
    const auto peak = std::max_element(sums.begin(), end);
    const double half = 0.5 * *peak;
    const auto below = std::find_if(peak, end, [&](double count) { return count < half; });
    // Between the middles of the last bin above the half and the first below it.
    const double fell = below == end ? 0 : (*(below - 1) - half) / (*(below - 1) - *below);
    const double halfWidth = width * (double(below - peak) - 1 + fell);
    const double air = range.lo + width * (double(peak - sums.begin()) + 0.5);
    const bool isOneValue = *peak > 0.5 * std::accumulate(sums.begin(), end, 0.0);
    const double way = isOneValue ? kWayFromOneValue : kWayFromNoise;
    return {air, std::min(object, std::max(air + kHalfWidths * halfWidth, std::lerp(air, object, way)))};
}

namespace {

constexpr int kPlaces = 256; // over the robust range
constexpr double kSigma = 4; // of them
constexpr double kLarge = 0.15;
constexpr Range kWayToDarker{0.6, 0.93};
constexpr double kUsualWayToDarker = 0.76;

struct Peak {
    double value = 0;
    double height = 0;
};

// Counts at equal places from one end of `robust` to the other, smoothed.
std::vector<double> smoothed(const std::vector<std::uint32_t>& counts, const Range& range,
                             const Range& robust) {
    std::vector<double> sums(kPlaces, 0);
    const double binWidth = range.width() / double(counts.size());
    const double reach = 4 * kSigma;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double value = range.lo + (double(i) + 0.5) * binWidth;
        const double place = (value - robust.lo) / robust.width() * (kPlaces - 1);
        if (counts[i] == 0 || place < -reach || place > kPlaces - 1 + reach) {
            continue;
        }
        const int from = std::max(0, int(std::ceil(place - reach)));
        const int to = std::min(kPlaces - 1, int(std::floor(place + reach)));
        for (int at = from; at <= to; ++at) {
            const double far = (at - place) / kSigma;
            sums[std::size_t(at)] += counts[i] * std::exp(-0.5 * far * far);
        }
    }
    return sums;
}

// The peaks above `from`, in ascending order.
std::vector<Peak> peaksAbove(double from, const std::vector<double>& sums, const Range& robust) {
    std::vector<Peak> peaks;
    for (std::size_t i = 1; i + 1 < sums.size(); ++i) {
        const double value = robust.lo + robust.width() * double(i) / (kPlaces - 1);
        if (value > from && sums[i] > sums[i - 1] && sums[i] >= sums[i + 1]) {
            peaks.push_back({value, sums[i]});
        }
    }
    return peaks;
}

struct Tissues {
    double darker = 0;
    double brighter = 0;
};

// Where noise hides one of the two, the darker one lies where it usually does; without any peak the brighter
// one is the middle of what is brighter than air.
Tissues tissuesOf(const std::vector<Peak>& peaks, double air, const Range& tissue) {
    Peak tallest{0.5 * (tissue.lo + tissue.hi), 0};
    for (const Peak& peak : peaks) {
        tallest = peak.height > tallest.height ? peak : tallest;
    }
    Tissues found{std::lerp(air, tallest.value, kUsualWayToDarker), tallest.value};
    double most = 0;
    for (const Peak& darker : peaks) {
        for (const Peak& brighter : peaks) {
            const double way = (darker.value - air) / (brighter.value - air);
            const bool areLarge = std::min(darker.height, brighter.height) >= kLarge * tallest.height;
            if (areLarge && kWayToDarker.contains(way) && darker.height + brighter.height > most) {
                most = darker.height + brighter.height;
                found = {darker.value, brighter.value};
            }
        }
    }
    return found;
}

// `counts` of all voxels, `inside` of those in the middle.
Landmarks landmarksOf(const std::vector<std::uint32_t>& counts, const std::vector<std::uint32_t>& inside,
                      const Range& range) {
    constexpr double odd = 0.001;
    const Range robust{percentile(counts, range, odd), percentile(counts, range, 1 - odd)};
    if (!(robust.width() > 0)) {
        return {robust.lo, robust.lo, robust.lo, robust.lo, std::max(robust.lo, range.hi)};
    }
    const Air air = findAir(counts, range, suggestRange(counts, range).lo);
    const double end = std::clamp(air.end, air.peak, std::max(air.peak, robust.hi));
    const auto peaks = peaksAbove(end, smoothed(inside, range, robust), robust);
    const Tissues tissues = tissuesOf(peaks, air.peak, {end, std::max(end, robust.hi)});
    Landmarks found{air.peak, end, 0, std::max(end, tissues.brighter), 0};
    found.darker = std::clamp(tissues.darker, end, found.brighter);
    // Never two at one place.
    found.top = std::max(robust.hi, found.brighter + 0.05 * (found.brighter - found.air));
    return found;
}

} // namespace

Landmarks findLandmarks(const Field& field) {
    const int bins = finestBins(field);
    const glm::ivec3 rim = field.geometry.dims / 4;
    const Box3 middle{rim, field.geometry.dims - rim};
    return landmarksOf(intensityHistogram(field, bins), intensityHistogram(field, middle, bins), field.usual);
}

Range findAirAndWater(const Landmarks& landmarks, const Range& range) {
    constexpr double airOfCt = -500; // scans moved up, and prepared ones, have no values so low
    constexpr double airToTissue = 1040;
    const double found = landmarks.brighter - landmarks.air;
    if (range.lo <= airOfCt) {
        return kAirAndWaterHu;
    }
    if (range.width() <= 255) {
        return {landmarks.air, landmarks.air + found * 1000 / airToTissue};
    }
    const bool isMovedUp = std::abs(found / airToTissue - 1) < 0.15;
    return isMovedUp ? Range{landmarks.air, landmarks.air + 1000} : kAirAndWaterHu;
}

} // namespace vs::field
