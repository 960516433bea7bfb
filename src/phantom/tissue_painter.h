// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

namespace vs::phantom {

// The value and the label of one voxel, painted over with one solid after another. A border that passes
// through the voxel mixes both sides by their shares (partial volume); the label is that of the larger one.
class TissuePainter {
public:
    // `value` is that of the background, whose label is 0.
    TissuePainter(double voxelMm, double value) : spreadMm_(kSpreadVoxels * voxelMm), value_(value) {}

    // Paints a solid whose signed distance in mm (negative inside) is known at the voxel's centre.
    void paint(double distance, double value, std::uint8_t label) {
        const double share = std::clamp(0.5 - distance / spreadMm_, 0.0, 1.0);
        value_ += share * (value - value_);
        label_ = distance < 0 ? label : label_;
    }
    [[nodiscard]] double value() const { return value_; }
    [[nodiscard]] std::uint8_t label() const { return label_; }

private:
    // The width over which a border is spread: a little more than a voxel, as scanners do.
    static constexpr double kSpreadVoxels = 1.4;

    double spreadMm_;
    double value_;
    std::uint8_t label_ = 0;
};

} // namespace vs::phantom
