// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vs::sculpt {

// Blurs a raster (x fastest) with three box filters along each axis, which together are close to a Gaussian
// of `sigma` elements at a cost that does not depend on it. Outside the raster is zero. T is float or a glm
// vector.
template <typename T>
void blurRaster(std::vector<T>& values, glm::ivec2 size, double sigma) {
    // A box of 2r + 1 elements has the variance ((2r + 1)^2 - 1) / 12; three of them make sigma^2.
    const int r = int(std::lround((std::sqrt(4 * sigma * sigma + 1) - 1) / 2));
    if (r < 1) {
        return;
    }
    const float scale = 1.0F / float(2 * r + 1);
    std::vector<T> source;
    std::vector<T> sums(std::size_t(size.x));
    for (int pass = 0; pass < 3; ++pass) {
        source = values;
        for (int j = 0; j < size.y; ++j) { // along x
            const T* from = &source[std::size_t(j) * std::size_t(size.x)];
            T* to = &values[std::size_t(j) * std::size_t(size.x)];
            T sum(0);
            for (int i = -r; i < size.x; ++i) {
                sum += i + r < size.x ? from[i + r] : T(0);
                sum -= i - r - 1 >= 0 ? from[i - r - 1] : T(0);
                if (i >= 0) {
                    to[i] = sum * scale;
                }
            }
        }
        source = values;
        std::fill(sums.begin(), sums.end(), T(0));
        for (int j = -r; j < size.y; ++j) { // along y, all columns at once
            const T* entering = j + r < size.y ? &source[std::size_t(j + r) * std::size_t(size.x)] : nullptr;
            const T* leaving =
                j - r - 1 >= 0 ? &source[std::size_t(j - r - 1) * std::size_t(size.x)] : nullptr;
            T* to = j >= 0 ? &values[std::size_t(j) * std::size_t(size.x)] : nullptr;
            for (int i = 0; i < size.x; ++i) {
                T& sum = sums[std::size_t(i)];
                sum += entering != nullptr ? entering[i] : T(0);
                sum -= leaving != nullptr ? leaving[i] : T(0);
                if (to != nullptr) {
                    to[i] = sum * scale;
                }
            }
        }
    }
}

} // namespace vs::sculpt
