// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/parallel.h"
#include "base/progress.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vs::segment {

// One pass of a separable filter over a block of values (x fastest): each value becomes the sum, or whatever
// `add` makes of it, of its neighbours along `axis` (from -r to r) under the weights (2 r + 1 of them):
// add(sum, neighbour, weight), beginning with `first`. The outermost values go on beyond the block.
// Neighbours are whole rows, so that processors take many at a time. May be given up between passes.
template <typename Add>
void filterAlong(int axis, std::vector<float>& values, glm::ivec3 size, const std::vector<float>& weights,
                 float first, Add add) {
    reportProgress();
    const std::size_t length(size[axis]);
    const std::size_t reach = weights.size() / 2;
    const std::size_t row(size.x);
    // A line of rows along y or z, or one row along x, where neighbours lie a value apart.
    const std::size_t apart = axis == 0 ? 1 : row;
    const std::size_t rows = axis == 0 ? 1 : length;
    const std::size_t stride = axis == 2 ? row * std::size_t(size.y) : row;
    const auto filterLine = [&](float* line) {
        std::vector<float> padded((length + 2 * reach) * apart);
        for (std::size_t i = 0; i < length + 2 * reach; ++i) {
            const std::size_t source = std::clamp(i, reach, reach + length - 1) - reach;
            std::copy_n(line + source * (axis == 0 ? 1 : stride), apart, padded.data() + i * apart);
        }
        for (std::size_t i = 0; i < rows; ++i) {
            float* const sums = line + i * stride;
            std::fill_n(sums, row, first);
            for (std::size_t k = 0; k < weights.size(); ++k) {
                const float* const neighbours = padded.data() + (i + k) * apart;
                const float weight = weights[k];
                for (std::size_t x = 0; x < row; ++x) {
                    sums[x] = add(sums[x], neighbours[x], weight);
                }
            }
        }
    };
    // Slices along z for passes along x and y, along y for one along z.
    const std::size_t slice = row * std::size_t(axis == 2 ? 1 : size.y);
    inParallel(axis == 2 ? size.y : size.z, [&](int index) {
        float* const begin = values.data() + std::size_t(index) * slice;
        for (int line = 0; line < (axis == 0 ? size.y : 1); ++line) {
            filterLine(begin + std::size_t(line) * row);
        }
    });
}

} // namespace vs::segment
