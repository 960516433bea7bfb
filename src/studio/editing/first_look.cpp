// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/first_look.h"

#include "field/histogram.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
#include <string>

namespace vs::studio {

namespace {

constexpr double kHalfWidths = 4; // above air's peak, that its noise reaches
// Of the way from air to the object: so far at least, and where air was set to one value, which tells of no
// noise, so far.
constexpr double kWayFromNoise = 0.25;
constexpr double kWayFromOneValue = 0.5;
constexpr int kAirBins = 64; // from the darkest value to the object: finer, scaled values comb
constexpr int kMostBins = 4096;
constexpr double kAirOfCt = -500; // HU: MR has no values so low

bool isProjected(const volume::Volume& volume) {
    constexpr std::array<const char*, 2> kModalities{"PT", "NM"};
    return volume.details.isAngiography ||
           std::any_of(kModalities.begin(), kModalities.end(),
                       [&](const char* modality) { return volume.details.modality == modality; });
}

// DICOM says so; and what NIfTI files hold are MR scans as a rule, unless values are as low as CT's.
bool isMr(const volume::Volume& volume) {
    std::string name = volume.path.filename().string();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return char(std::tolower(letter)); });
    const bool isNifti = name.ends_with(".nii") || name.ends_with(".nii.gz");
    return volume.details.modality == "MR" ||
           (volume.details.modality.empty() && isNifti && volume.range.lo > kAirOfCt);
}

// So many bins as one.
std::vector<double> joined(const std::vector<std::uint32_t>& counts, std::size_t bins) {
    std::vector<double> sums((counts.size() + bins - 1) / bins, 0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        sums[i / bins] += counts[i];
    }
    return sums;
}

} // namespace

double aboveAir(const std::vector<std::uint32_t>& counts, const Range& range, double object) {
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
    return std::min(object, std::max(air + kHalfWidths * halfWidth, std::lerp(air, object, way)));
}

FirstLook firstLook(const volume::Volume& volume, const field::Field& field, const Range& suggested) {
    FirstLook look{suggested, isProjected(volume) ? render::Mode::Mip : render::Mode::Surface};
    if (volume.range.width() <= 0 || !(isMr(volume) || isProjected(volume))) {
        return look;
    }
    const int bins = field.isIntegral
                         ? std::clamp(int(std::min(field.range.width(), double(kMostBins))), 1, kMostBins)
                         : kMostBins;
    auto counts = field::intensityHistogram(field, bins);
    const double lo = aboveAir(counts, volume.range, suggested.lo);
    look.range.lo = field.isIntegral ? std::ceil(lo) : lo;
    if (isProjected(volume)) {
        const auto dark = std::ptrdiff_t(double(bins) * (lo - volume.range.lo) / volume.range.width());
        std::fill(counts.begin(), counts.begin() + std::clamp(dark, std::ptrdiff_t(0), std::ptrdiff_t(bins)),
                  0U);
        constexpr double saturates = 0.001;
        const double hi = field::percentile(counts, volume.range, 1 - saturates);
        look.range.hi = hi > look.range.lo ? hi : volume.range.hi;
    }
    return look;
}

} // namespace vs::studio
