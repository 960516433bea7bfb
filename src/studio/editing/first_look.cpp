// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/first_look.h"

#include "field/histogram.h"
#include "field/landmarks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

namespace vs::studio {

namespace {

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
           (volume.details.modality.empty() && isNifti && volume.usual.lo > kAirOfCt);
}

} // namespace

FirstLook firstLook(const volume::Volume& volume, const field::Field& field, const Range& suggested) {
    FirstLook look{suggested, isProjected(volume) ? render::Mode::Mip : render::Mode::Surface};
    if (volume.usual.width() <= 0 || !(isMr(volume) || isProjected(volume))) {
        return look;
    }
    const int bins = field::finestBins(field);
    auto counts = field::intensityHistogram(field, bins);
    const double lo = field::findAir(counts, volume.usual, suggested.lo).end;
    look.range.lo = field.isIntegral ? std::ceil(lo) : lo;
    if (isProjected(volume)) {
        const auto dark = std::ptrdiff_t(double(bins) * (lo - volume.usual.lo) / volume.usual.width());
        std::fill(counts.begin(), counts.begin() + std::clamp(dark, std::ptrdiff_t(0), std::ptrdiff_t(bins)),
                  0U);
        constexpr double saturates = 0.001;
        const double hi = field::percentile(counts, volume.usual, 1 - saturates);
        look.range.hi = hi > look.range.lo ? hi : volume.usual.hi;
    }
    return look;
}

} // namespace vs::studio
