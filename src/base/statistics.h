// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vs {

// The middle value, or the mean of the two in the middle; 0 of nothing.
inline double median(std::vector<double> values) {
    if (values.empty()) {
        return 0;
    }
    const std::size_t middle = values.size() / 2;
    const auto place = values.begin() + std::ptrdiff_t(middle);
    std::nth_element(values.begin(), place, values.end());
    if (values.size() % 2 == 1) {
        return *place;
    }
    return 0.5 * (*place + *std::max_element(values.begin(), place));
}

} // namespace vs
