// SPDX-License-Identifier: Apache-2.0
#include "field/voxel_rows.h"

#include "base/timer.h"
#include "gl/context.h"

#include <algorithm>
#include <cmath>

namespace vs::field {

bool VoxelRows::advance(gl::Program& program, double budgetMs) {
    constexpr std::size_t kAtOnce = std::size_t(1) << 22;
    const Timer timer;
    const int rows = divideUp(dims_.y, 8);
    const std::size_t perRow = std::size_t(dims_.x) * 8 * std::size_t(dims_.z);
    const int rowsAtOnce = std::max(1, int(kAtOnce / std::max(perRow, std::size_t(1))));
    while (next_ < rows) {
        program.set("firstRow", next_);
        program.dispatch({divideUp(dims_.x, 8), std::min(rowsAtOnce, rows - next_), 1}, gl::Barrier::All);
        next_ += rowsAtOnce;
        if (std::isfinite(budgetMs)) {
            gl::Context::finish();
            if (timer.milliseconds() >= budgetMs) {
                break;
            }
        }
    }
    return isDone();
}

} // namespace vs::field
