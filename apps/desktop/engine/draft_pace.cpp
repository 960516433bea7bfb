// SPDX-License-Identifier: Apache-2.0
#include "engine/draft_pace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr std::array kScales{1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0};
// What fewer pixels take says more of what each draft takes before its first ray.
constexpr double kFewPixels = 20000;
} // namespace

double DraftPace::choose(double pixels, double milliseconds) {
    if (nanosPerPixel_ == 0) {
        return scale_;
    }
    const double wanted = std::sqrt(nanosPerPixel_ * 1e-6 * std::max(pixels, kFewPixels) / milliseconds);
    // Stays where it is when that is nearly right, or the picture would flicker between two scales.
    if (wanted > 0.7 * scale_ && wanted < 1.1 * scale_) {
        return scale_;
    }
    const auto fits = [&](double scale) { return scale >= 0.95 * wanted; };
    const auto found = std::find_if(kScales.begin(), kScales.end(), fits);
    scale_ = found != kScales.end() ? *found : kScales.back();
    return scale_;
}

void DraftPace::note(double pixels, double milliseconds) {
    const double nanos = milliseconds * 1e6 / std::max(pixels, kFewPixels);
    // The first draft of a mode includes compiling its shader, so one slow draft is not believed at once.
    nanosPerPixel_ =
        nanosPerPixel_ == 0 ? nanos : 0.5 * nanosPerPixel_ + 0.5 * std::min(nanos, 2 * nanosPerPixel_);
}

} // namespace vs::desktop
