// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "field/fill/fill_texture.h"

#include <cstdint>
#include <vector>

namespace vs::field {

// Which macrocells of a scan may hold material, and what values each may have with it.
class FilledCells {
public:
    // Brings them up to date. `scan`: the ranges of the scan's own values, which must stay as they are while
    // `serial` does.
    void update(const gl::Texture& scan, std::uint64_t serial, const SharedFill& fill,
                const ShownMaterials& materials);

    // RG32F: smallest and largest value in each cell, of the scan and of material.
    [[nodiscard]] const gl::Texture& ranges() const { return ranges_; }
    // A number that is no other's and moves on with every change of ranges().
    [[nodiscard]] std::uint64_t serial() const { return serial_; }
    // R8: 1 where there may be material.
    [[nodiscard]] const gl::Texture& filled() const { return filled_; }

private:
    void begin(const gl::Texture& scan, std::uint64_t serial);
    void updateIn(std::uint32_t place, const Fill& fill);

    std::uint64_t scanSerial_ = 0;
    const gl::Texture* scan_ = nullptr;
    std::vector<glm::vec2> own_; // the scan's
    SharedFill shown_;
    std::vector<float> values_; // of the materials
    gl::Texture ranges_;
    gl::Texture filled_;
    std::uint64_t serial_ = 0;
};

} // namespace vs::field
