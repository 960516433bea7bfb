// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/program.h"

#include <limits>

namespace vs::field {

inline constexpr double kUnlimitedMs = std::numeric_limits<double>::infinity();

// One pass over all voxels by a shader whose work groups go along 8 x 8 columns in z, split so that there is
// no long submission (some 40 ms on two cores of a software renderer). The shader takes the number of its
// first row of work groups as the uniform `firstRow`.
class VoxelRows {
public:
    VoxelRows() = default;
    explicit VoxelRows(glm::ivec3 dims) : dims_(dims) {}

    // Dispatches the next rows for about `budgetMs`, at least once. True when all voxels are done. With a
    // limit it waits for the device after each dispatch.
    bool advance(gl::Program& program, double budgetMs);
    [[nodiscard]] bool isDone() const { return next_ >= divideUp(dims_.y, 8); }

private:
    glm::ivec3 dims_{0};
    int next_ = 0;
};

} // namespace vs::field
