// SPDX-License-Identifier: Apache-2.0
#include "field/histogram.h"

#include "base/check.h"
#include "field/shaders/bindings.h"
#include "gl/context.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "volume/grid/histogram.h"

#include <algorithm>
#include <numeric>

namespace vs::field {

namespace {

void bind(gl::Program& program, const Field& field, const Box3& box, int bins, const gl::Buffer& counts) {
    counts.bindStorage(kCountsStorage);
    field.texels.bindTexture(kDataTexture);
    program.set("first", box.lo)
        .set("last", box.hi - 1)
        .set("bins", bins)
        .set("valueScaleOffset", glm::vec3(field.valueScale, field.valueOffset, field.isIntegral ? 1 : 0))
        .set("valueRange", glm::vec2(float(field.usual.lo), float(field.usual.hi)));
}

Box3 wholeOf(const Field& field) { return {glm::ivec3(0), field.geometry.dims}; }

} // namespace

int finestBins(const Field& field) {
    constexpr int most = 4096;
    return field.isIntegral ? int(std::clamp(field.usual.width(), 1.0, double(most))) : most;
}

std::vector<std::uint32_t> intensityHistogram(const Field& field, int bins) {
    return intensityHistogram(field, wholeOf(field), bins);
}

std::vector<std::uint32_t> intensityHistogram(const Field& field, const Box3& box, int bins) {
    VS_CHECK(bins >= 1 && bins <= 4096);
    VS_CHECK(!box.isEmpty() && intersect(box, wholeOf(field)) == box);
    if (field.onHost != nullptr && gl::Context::isSoftware()) {
        const auto counts = volume::histogram(*field.onHost, box, bins);
        return {counts.begin(), counts.end()};
    }
    const gl::Pass pass("intensity histogram");
    gl::Program program("field/shaders/count_histogram.comp", {{"VISIBLE", "0"}});
    gl::Buffer counts(std::size_t(bins) * sizeof(std::uint32_t), "histogram");
    bind(program, field, box, bins, counts);
    VoxelRows(box.size()).advance(program, kUnlimitedMs);
    return counts.read<std::uint32_t>(std::size_t(bins));
}

VisibleHistogram::VisibleHistogram(const Field& field, int bins)
    : field_(&field), bins_(bins), program_("field/shaders/count_histogram.comp", {{"VISIBLE", "1"}}) {
    VS_CHECK(bins >= 1 && bins <= 4096);
}

void VisibleHistogram::start(SculptureView view) { start(view, wholeOf(*field_)); }

void VisibleHistogram::start(SculptureView view, const Box3& box) {
    VS_CHECK(view != SculptureView::Whole); // that is intensityHistogram()
    VS_CHECK(intersect(box, wholeOf(*field_)) == box);
    view_ = view;
    box_ = box;
    counts_ = gl::Buffer(std::size_t(bins_) * sizeof(std::uint32_t), "visible histogram");
    rows_ = VoxelRows(box.size());
}

bool VisibleHistogram::advance(const gl::Texture& sculpture, double budgetMs) {
    const gl::Pass pass("visible histogram");
    bind(program_, *field_, box_, bins_, counts_);
    sculpture.bindTexture(kSculptureTexture);
    program_.set("sculptureView", view_ == SculptureView::Cut ? 1 : 2);
    return rows_.advance(program_, budgetMs);
}

std::vector<std::uint32_t> VisibleHistogram::counts() const {
    VS_CHECK(rows_.isDone());
    return counts_.read<std::uint32_t>(std::size_t(bins_));
}

double percentile(const std::vector<std::uint32_t>& histogram, const Range& range, double part) {
    const auto total = std::accumulate(histogram.begin(), histogram.end(), std::uint64_t(0));
    const double width = range.width() / double(histogram.size());
    double left = part * double(total);
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        const double here = histogram[i];
        if (here > 0 && here >= left) {
            return range.lo + width * (double(i) + left / here);
        }
        left -= here;
    }
    return range.hi;
}

double countWithin(const std::vector<std::uint32_t>& histogram, const Range& range, const Range& wanted) {
    const double width = range.width() / double(histogram.size());
    double count = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        const double lo = range.lo + width * double(i);
        const double hi = lo + width;
        const double part = width > 0 ? (std::min(hi, wanted.hi) - std::max(lo, wanted.lo)) / width
                                      : double(wanted.contains(lo));
        count += std::clamp(part, 0.0, 1.0) * histogram[i];
    }
    return count;
}

Range suggestRange(const std::vector<std::uint32_t>& histogram, const Range& range) {
    const std::vector<std::uint64_t> counts(histogram.begin(), histogram.end());
    return {volume::otsuThreshold(counts, range), range.hi};
}

} // namespace vs::field
