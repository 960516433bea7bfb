// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>

namespace vs::marking {

// What a pen leaves behind.
struct Ink {
    std::array<std::uint8_t, 3> colour{}; // sRGB
    bool erases = false;                  // takes away what is there instead
};

// A texel after ink has been laid on it: so much of it is covered, so opaque is the ink.
field::MarkTexel inked(const field::MarkTexel& texel, std::uint8_t coverage, std::uint8_t opacity,
                       const Ink& ink);

// What one stroke covers. Wherever it passes more than once the most counts, so that it does not matter how
// slowly or how often the pen goes there; and only then it is laid on what was marked before.
class MarkLayer {
public:
    explicit MarkLayer(const field::MarkGrid& grid) : grid_(grid) {}

    [[nodiscard]] const field::MarkGrid& grid() const { return grid_; }
    // Raises what covers a texel of the grid; both from 0 to 1.
    void cover(glm::ivec3 texel, double coverage, double opacity);
    // `before` with all of the layer on it. `now` is what this gave the last time, or `before`: only what has
    // been covered since is laid again.
    [[nodiscard]] field::Marks on(const field::Marks& before, const field::Marks& now, const Ink& ink);
    [[nodiscard]] std::size_t bricks() const { return bricks_.size(); }

private:
    struct Covered {
        std::uint8_t coverage = 0;
        std::uint8_t opacity = 0;
    };
    using Brick = std::array<Covered, field::kMarkTexels>;

    field::MarkGrid grid_;
    std::map<std::uint32_t, Brick> bricks_;
    std::set<std::uint32_t> touched_;
    Brick* last_ = nullptr; // the one covered before, most likely again
    std::uint32_t lastPlace_ = 0;
};

} // namespace vs::marking
