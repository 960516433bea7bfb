// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/scan.h"

#include "base/check.h"
#include "field/histogram.h"
#include "render/slices/slice_windows.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

// Greys of cut faces: the values of the object (those above `objectFrom`) without the darkest hundredth and
// the brightest three.
Range greyWindow(const std::vector<std::uint32_t>& histogram, const Range& range, double objectFrom) {
    const double binWidth = range.width() / double(histogram.size());
    const auto countsFrom = [&](std::size_t bin) {
        return range.lo + double(bin + 1) * binWidth > objectFrom;
    };
    double total = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        total += countsFrom(i) ? histogram[i] : 0;
    }
    Range window{range.lo, range.hi};
    double seen = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        const double before = seen;
        seen += countsFrom(i) ? histogram[i] : 0;
        if (before <= 0.01 * total && seen > 0.01 * total) {
            window.lo = range.lo + double(i) * binWidth;
        }
        if (before < 0.97 * total && seen >= 0.97 * total) {
            window.hi = range.lo + double(i + 1) * binWidth;
        }
    }
    // The darkest tissue of the object is dark grey, not black.
    window.lo = std::max(range.lo, window.lo - 0.25 * window.width());
    return window;
}

// What slices show: of Hounsfield units those of soft tissue, else all from the darkest two hundredths up to
// all but the brightest half a hundredth of the object (values above `objectFrom`), so that what is darker
// than the object, as cerebrospinal fluid is in a head of an MR scan, is told from air.
Range sliceWindow(const std::vector<std::uint32_t>& histogram, const volume::Volume& volume,
                  double objectFrom) {
    const Range& range = volume.usual;
    const Range soft = render::kAbdomenWindow;
    if (volume.unit == "HU" && range.lo < soft.lo && range.hi > soft.hi) {
        return soft;
    }
    const double binWidth = range.width() / double(histogram.size());
    auto object = histogram;
    for (std::size_t i = 0; i < object.size() && range.lo + double(i + 1) * binWidth <= objectFrom; ++i) {
        object[i] = 0;
    }
    const Range window{field::percentile(histogram, range, 0.02), field::percentile(object, range, 0.995)};
    return window.width() > 0 ? window : range;
}

// 256 bins, or one for each step from value to value where whole numbers are fewer: bins of uneven size would
// comb.
int histogramBins(const field::Field& field) {
    return field.isIntegral ? std::clamp(int(std::min(field.usual.width(), 256.0)), 1, 256) : 256;
}

} // namespace

Scan::Scan(volume::Volume opened)
    : inFile(opened.geometry), volume(std::move(opened)), field(field::uploadVolume(volume)) {
    field.onHost = &volume;
    histogram = field::intensityHistogram(field, histogramBins(field));
    shown = field::suggestRange(histogram, volume.usual);
    if (volume.usual.width() <= 0) { // one value all over: all of it is the object
        shown = {volume.usual.lo - 0.5, volume.usual.hi + 0.5};
    } else if (field.isIntegral) {
        shown.lo = std::ceil(shown.lo);
    }
    firstLook = studio::firstLook(volume, field, shown);
    grey = volume.usual.width() > 0 ? greyWindow(histogram, volume.usual, shown.lo)
                                    : Range{volume.usual.lo - 3, volume.usual.hi + 1};
    slices = volume.usual.width() > 0 ? sliceWindow(histogram, volume, shown.lo) : grey;
    if (field.isIntegral) {
        slices = {std::floor(slices.lo), std::ceil(slices.hi)};
    }
}

void Scan::lay(const volume::GridGeometry& geometry) {
    VS_CHECK(geometry.dims == inFile.dims);
    volume.geometry = geometry;
    field.geometry = geometry;
    field.serial = field::nextSerial();
}

} // namespace vs::studio
