// SPDX-License-Identifier: Apache-2.0
#include "image/compare.h"

#include "base/error.h"

#include <algorithm>
#include <cstdlib>

namespace vs::image {

Difference compare(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) {
        throw Error("pictures differ in size: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
    }
    Difference result;
    double sum = 0;
    std::size_t changed = 0;
    const std::size_t pixels = a.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        int worst = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int d = std::abs(int(a.rgba[4 * i + c]) - int(b.rgba[4 * i + c]));
            sum += d;
            worst = std::max(worst, d);
        }
        result.max = std::max(result.max, worst);
        changed += worst > 8 ? 1 : 0;
    }
    if (pixels > 0) {
        result.mean = sum / double(3 * pixels);
        result.changedFraction = double(changed) / double(pixels);
    }
    return result;
}

} // namespace vs::image
