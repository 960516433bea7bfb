// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vs::studio {

// How far what is cut at the finest level beside a coarser one is from what is cut where all of it is there.
// Places are found in the scene's voxel space and not in the finest level's, so numbers may differ by
// rounding.
struct CutDifference {
    double most = 0;
    double largeFraction = 0; // of the voxels that are cut: differ by more than a hundredth
    std::size_t cut = 0;
};
inline CutDifference differenceOf(const std::vector<float>& a, const std::vector<float>& b) {
    CutDifference difference;
    std::size_t large = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        const double off = std::abs(double(a[n]) - double(b[n]));
        difference.most = std::max(difference.most, off);
        large += off > 0.01 ? 1 : 0;
        difference.cut += a[n] >= 0.5F ? 1 : 0;
    }
    difference.largeFraction = double(large) / double(std::max<std::size_t>(difference.cut, 1));
    return difference;
}

} // namespace vs::studio
