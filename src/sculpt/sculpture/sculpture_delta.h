// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/brick_backup.h"
#include "sculpt/sculpture/fine_sculpture.h"

#include <algorithm>
#include <utility>

namespace vs::sculpt {

// One change of a sculpture and, where it has one, of its finer one.
struct SculptureDelta : BrickDelta {
    SculptureDelta() = default;
    SculptureDelta(BrickDelta change) : BrickDelta(std::move(change)) {} // of one without a finer one
    SculptureDelta(BrickDelta change, FineDelta finest)
        : BrickDelta(std::move(change)), finer(std::move(finest)) {}

    FineDelta finer;

    [[nodiscard]] bool isEmpty() const { return BrickDelta::isEmpty() && finer.isEmpty(); }
    // Counts the finer one's voxels, where that has changed.
    [[nodiscard]] std::size_t changedVoxels() const {
        return finer.isEmpty() ? BrickDelta::changedVoxels() : finer.changedVoxels;
    }
    [[nodiscard]] std::size_t memoryBytes() const { return BrickDelta::memoryBytes() + finer.memoryBytes(); }
};

} // namespace vs::sculpt
