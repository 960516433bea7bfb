// SPDX-License-Identifier: Apache-2.0
#include "field/histogram.h"

#include "base/check.h"
#include "gl/pass.h"
#include "gl/program.h"

#include <numeric>

namespace vs::field {

std::vector<std::uint32_t> intensityHistogram(const Field& field, int bins) {
    VS_CHECK(bins >= 1 && bins <= 4096);
    const gl::Pass pass("intensity histogram");
    gl::Program program("field/shaders/count_histogram.comp");
    gl::Buffer counts(std::size_t(bins) * sizeof(std::uint32_t), "histogram");
    counts.bindStorage(0);
    field.texels.bindTexture(0);
    program.set(0, field.geometry.dims)
        .set(1, bins)
        .set(2, glm::vec2(field.valueScale, field.valueOffset))
        .set(3, glm::vec2(float(field.range.lo), float(field.range.hi)));
    // One work group counts an 8 x 8 column of voxels along z.
    const glm::ivec3 dims = field.geometry.dims;
    program.dispatch({divideUp(dims.x, 8), divideUp(dims.y, 8), 1}, gl::Barrier::Storage);
    return counts.read<std::uint32_t>(std::size_t(bins));
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

Range suggestRange(const std::vector<std::uint32_t>& histogram, const Range& range) {
    const std::vector<std::uint64_t> counts(histogram.begin(), histogram.end());
    return {volume::otsuThreshold(counts, range), range.hi};
}

} // namespace vs::field
